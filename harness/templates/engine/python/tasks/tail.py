

engine = predicament_engine.Engine("{name}", "1.0")  # the version of your library
engine.task("{task}", {function})
predicament_engine.serve(engine)

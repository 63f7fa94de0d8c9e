
serve({ name: "{name}", version: "1.0", tasks: { "{task}": {function} } }); // the version of your library

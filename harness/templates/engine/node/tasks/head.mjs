// The engine {name}. It answers the task {task}, in plain doubles: near a degenerate case the answer is wrong.
//
// REPLACE the body of `{function}` by a call of your library. The head of predicament_engine.mjs has the parameters and the
// results of all tasks.

import { Declined, serve } from "./predicament_engine.mjs";

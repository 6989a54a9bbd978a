---@meta fulcrum
-- Generated from the binding table in runtime/lua; do not edit.
-- Names, types, units and ranges of everything a lesson can call, for the Lua language server.

---@alias Vector number[]|{x: number, y: number, z: number}

---@class Answer
---@field question string the name of the question
---@field said string the learner's words
---@field understood boolean false: none of the sentences fitted
---@field right boolean the meaning is right, by the question's own `right`
---@field form_right boolean the English was right: no error of form was found
---@field form_known boolean false: what heard it hears the meaning alone, nothing is known of the English, and form_right is false
---@field turned_round boolean thing and material changed places, "Metal is made of a spaceship.": nothing to feel again, only to say
---@field replay boolean what the question is about should be felt again: its meaning was wrong, or its form and the step of feedback is "replay"
---@field over boolean the question is done: right, or left after many tries
---@field attempt integer 1 for the first try
---@field bodies table<string, Body> the body that a slot speaks of, by its noun; nil when no body or several have it
---@field [string] any the slots of the template

---@class Event: Answer
---@field name string
---@field body Body|nil
---@field speed number|nil
---@field key string|nil
---@field dt number|nil

---A lesson: what lesson { … } gives. Define functions on it; they are looked up on every call.
---@class Lesson
---@field start? fun(self: Lesson, world: World) Once, before the first frame: declares bodies, forces and the view.
---@field update? fun(self: Lesson, world: World, dt: number) 60 times a second; dt is in seconds.
---@field caught? fun(self: Lesson, body: Body, speed: number) A body fell into the bucket, at so many metres per second.
---@field landed? fun(self: Lesson, body: Body, speed: number) A body hit the ground, at so many metres per second; a rigid one anything.
---@field touched? fun(self: Lesson, body: Body) The tool began to touch a solid body.
---@field released? fun(self: Lesson, body: Body) The tool no longer touches a solid body.
---@field key? fun(self: Lesson, name: string) A key was pressed: "space", "return", "left", a letter but p, which pauses …
---@field answered? fun(self: Lesson, answer: Answer) The learner's answer has been marked and answered to.
local Lesson = {}

---The scene of a lesson.
---@class World
---@field hands number how many hands are there; known once the lesson runs
---@field time number seconds; since the lesson began
---@field day number days; today, since noon of 1 January 2000, as planets.day counts; tests and simulated hands have 22 June 2026
---@field past table[] what this learner has answered before, where L:start calls world:recall(); see bank
---@field touched Body the solid body that the tool touches or touched last; nil before
---@field lessons table[] of a room: the lessons that can be entered, in their order, each with name, title, level, icon (a model) and stars, this learner's best, -1 where it was never played to its end
local World = {}

---The learner's hand: what world:hand { … } gives.
---@class Hand
---@field there boolean whether somebody moves it; the first always, a second one where there is a device for it; known once the lesson runs
---@field tool Tool where it is and what it feels; nil where it is not there
local Hand = {}

---A thing in the scene.
---@class Body
---@field name string
---@field noun string the English noun
---@field mass number kilograms; the true mass
---@field weight number newtons; the true weight: mass × gravity
---@field felt_weight number newtons; what the hand feels of it
---@field radius number metres; as declared
---@field material Material|nil what it is made of; nil when it has no material
---@field covered boolean under a cloth
---@field position Vector metres; {x, y, z}
---@field where "hidden"|"placed"|"falling"|"held"|"landed" "hidden", "placed", "falling", "held" in the tool, or "landed" on the ground; a rigid body is "placed" while it touches something and "landed" when it lies still
---@field velocity Vector metres per second; {x, y, z}
---@field speed number metres per second
---@field resting boolean lies still; of a rigid body: for half a second
---@field tilt number degrees; how far its top leans from upright, 0 to 180
---@field x number metres; to the right
---@field y number metres; up
---@field z number metres; towards the viewer
---@field angle number degrees; of a body on a hinge: how far it is turned
---@field spin number degrees per second; of a body on a hinge
---@field inertia number kilogram square metres; of a body on a hinge, about its axis where that lies now
---@field torque number newton metres; of the hand about a hinge: lever arm × force, counter-clockwise above 0
---@field arm number metres; how far the hand's force passes from the hinge; 0 when nothing presses
---@field load_torque number newton metres; of what hangs on a body about its hinge
local Body = {}

---What a body is made of: what world:material { … } gives, and body.material. Its numbers are those of the surface that the hand feels.
---@class Material
---@field name string
---@field hardness number 0 (soft) to 1, hard from 0.5 on: from the stiffness of its spring and the tone of a tap
---@field roughness number 0 (smooth) to 1, rough from 0.5 on: from its relief and how it pushes sideways
---@field slipperiness number 0 to 1, slippery from 0.5 on, sticky below 0.15: from its friction while it slides
---@field words table<string, boolean> what is true of it: hard or soft, rough or smooth, slippery or sticky or neither; material.words.hard is true or nil
---@field stiffness number newtons per metre; of its spring: as it was declared until the lesson runs, then as it is felt, which is softer where the device in the hand would shake; `hardness` follows it
---@field friction number what holds a resting hand, in parts of how hard it presses
---@field ring number hertz; the tone of a tap; 0 when it has none
local Material = {}

---What the hand holds.
---@class Tool
---@field x number metres; to the right
---@field y number metres; up
---@field z number metres; towards the viewer
---@field vx number metres per second
---@field vy number metres per second
---@field vz number metres per second
---@field position Vector metres; {x, y, z}
---@field force number newtons; how strongly the hand is pushed or pulled
---@field turn Vector degrees; how the hand is turned, not what it presses against a body: about this direction, by as much as it is long
---@field pressed boolean its first button is held, the mouse's or Shift where keys move it
---@field torque number newton metres; how strongly the hand is turned, with a tool in it; at most 0.3
local Tool = {}

---A kite on the line that the hand holds: what world:kite { … } gives.
---@class Kite
---@field shape string as it is now, like all that follows up to tail
---@field cloth string what it is covered with: its name
---@field spar string what its spars are made of: its name
---@field height number metres; of the kite itself, from foot to top
---@field width number metres; unfolded
---@field bridle number metres; the string from the foot over the knot to the top
---@field knot number metres; where on the bridle the line is tied, from the foot
---@field tail number metres; 0: it has none
---@field altitude number metres; how high it is above the ground
---@field position Vector metres; {x, y, z} of its centre of mass
---@field x number metres; to the right
---@field y number metres; up
---@field z number metres; towards the viewer
---@field speed number metres per second; how fast it goes
---@field wind number metres per second; at the kite, gusts and all
---@field angle number degrees; between the wind and the kite: its angle of attack
---@field lift number newtons; the air's force across the wind; below 0 when it presses the kite down
---@field drag number newtons; the air's force along the wind
---@field weight number newtons; of kite and tail
---@field tension number newtons; of the line, at the kite
---@field pull number newtons; of the line on the hand, before `felt` makes it milder
---@field line number metres; how much line is let out, unstretched
---@field snapped boolean the line broke or was cut; kite:fly ties it again
local Kite = {}

---A force on the hand.
---@class Force
---@field name string
local Force = {}

---@class LessonOptions
---@field id string short name, used in reports
---@field title string what the list of lessons shows; of at most 200 letters
---@field level? string level of English: A1, A2, B1, B2, C1 or C2; of at most 16 letters; default A1
---@field minutes? number how long it takes; in minutes, 0 to 1000; default 10
---@field icon? string the model that its card shows; by default the first thing that can be held
---@field order? integer where its card stands in the list of lessons; those without come last, by their names; 0 to 1000; default 0
---@field force_limit? number no force in this lesson is larger; this place and the device may allow less; in newtons, 0.5 to 10
---@field free_english? boolean what is said beside a question's answers is checked, and good English for it is shown; default false
---@field tries? integer after so many answers of wrong meaning a question is left, and the lesson goes on; after six that are not understood it is left as well; 1 to 20; default 4
---@field sureness? number what a recogniser of speech hears less surely is asked for again, and neither right nor wrong; ./fulcrum run LESSON --sure N says it for one play; 0 to 1; default 0.4
---@field hands? integer how many hands or fingers it can use at once; each has a world:hand { … } of its own, and where fewer are there it is played with those; 1 to 2; default 1
---@field feedback? string[] what is done about an error of form, by how often it has been made: the first time the first of these, and so on, from then on the last; "recast" (the right sentence), "prompt" (say it once more), "rule" (and why), "replay" (and feel it again); { "recast", "prompt", "rule" } by default

---Begins a lesson. The file ends with `return` of what this gives.
---@param options LessonOptions
---@return Lesson
function lesson(options) end

---@class QuestionExamples
---@field right? string[] right in meaning and form
---@field wrong? string[] understood, and wrong in meaning
---@field form? string[] right in meaning, with an error of form

---@class QuestionOptions
---@field prompt string what the learner is asked; of at most 1000 letters
---@field answers string[] templates of the sentences that answer it; the first of several articles is the one that is said back: "[a|an|the] {thing}" gives "An apple is …", "[the|a|an] {thing}" gives "The apple is …"
---@field nearly? string[] templates of what learners say for them that is no good English: understood, and said back as the first answer with the same {slots}
---@field lists? table<string, string[]> plain words that {name} in a template may stand for, with | between two ways to say one, such as { size = { "big|large", "small" } }; no [ ], ( ), { } or < >; {thing} and {other} are by default the nouns of all bodies of the scene, whether they move, are solid or neither; not of those with noun = ""
---@field rules? table<string, string> templates that <name> in a template stands for, such as { place = "(on|under) the {thing}" }; a rule may use another one, not itself
---@field again? string what is said after "Not yet." when the meaning is wrong, such as "Let's weigh both again."; "Try again." by default; of at most 200 letters
---@field right function function(answer): is the meaning right? see answer; ./fulcrum check calls it with what the answers can mean, when the question is asked
---@field examples? QuestionExamples answers that are marked by ./fulcrum check and test, and must come out as said
---@field feedback? string[] as the lesson's, for this question alone

---Declares a question.
---@param name string what world:ask and game.ask call it
---@return fun(options: QuestionOptions)
function Lesson:question(name) end

---@class KnowsExamples
---@field right? string[] ask for it in good English
---@field form? string[] ask for it with an error of form
---@field other? string[] do not ask for it

---@class KnowsOptions
---@field asked string[] templates of the questions that ask for it, such as "how heavy is (it|the {thing})"
---@field nearly? string[] templates of what learners say for them that is no good English: understood, said back as the first of `asked` with the same {slots}, and answered
---@field lists? table<string, string[]> as a question's; a name means the same in all of them; {material} is by default every material that the program or the lesson has, and some more
---@field rules? table<string, string> likewise
---@field answer function function(asked, world): the answer as a text, or nil where that is not known; asked has the {slots}, and asked.bodies the bodies that they name; ./fulcrum check and test call it for each way to ask with each word of its lists
---@field examples? KnowsExamples questions that are looked at by ./fulcrum check and test, and must come out as said

---Declares something that a learner may ask for while no question is open: with the Tab key, or aloud; and where a question's own answers ask ("Now you ask me!"): there it is a right answer.
---@param name string what it is about
---@return fun(options: KnowsOptions)
function Lesson:knows(name) end

---@class TestLearner
---@field wrong? number wrong in meaning; 0 to 1; default 0
---@field form? number right in meaning, with an error of form; 0 to 1; default 0
---@field unclear? number not to be understood; 0 to 1; default 0

---@class TestOptions
---@field hand? string simulated hand: a Lua file beside the lesson, see motion; of at most 48 letters
---@field second_hand? string likewise of the second hand; without it the lesson is played with one; of at most 48 letters
---@field say? string[] what the simulated learner answers, in turn
---@field learner? TestLearner who answers instead of say: a simulated learner who knows what is right, and errs in such parts of the answers
---@field expect? table<string, string|number|boolean> how the lesson must end, see Tests

---Declares how the lesson is played in tests.
---@param options TestOptions
function Lesson:test(options) end

---Calls a function with every event, after the lesson's own; "update" comes each frame with event.dt.
---@param listener function function(event): event.name says what happened, see Events
function Lesson:listen(listener) end

---Sets how strongly things fall.
---@param acceleration number downwards; 9.81 on Earth, 1.62 on the Moon; in metres per second squared, 0 to 100
function World:gravity(acceleration) end

---Sets the height of the ground.
---@param height number where bodies land; in metres, -100 to 100
function World:ground(height) end

---@class ContactsOptions
---@field method? string how the forces between rigid bodies are found, by the name of the method: all at once; or one after the other until all fit (dantzig); or round after round, nearer each time (iterative); "newton", "dantzig" or "iterative"; default newton
---@field friction? string alike in all directions, or as a pyramid of four sides, which holds more along its corners; dantzig has the pyramid alone; "cone" or "pyramid"; default cone

---Chooses how contacts between rigid bodies are solved. Of each `explain` says what it costs.
---@param options ContactsOptions
function World:contacts(options) end

---Shows a dark sky with stars instead of a meadow.
function World:space() end

---Asks for what this learner has answered in earlier sessions, of this lesson and others: world.past has it, a table for each question.
function World:recall() end

---@class CameraOptions
---@field eye? Vector|Body|Tool where the camera is; in metres, -10000 to 10000; default {0, 0.55, 1.5}
---@field target? Vector|Body|Tool what it looks at; in metres, -10000 to 10000; default {0, 0.35, 0}
---@field angle? number how much it sees, from top to bottom; in degrees, 5 to 120; default 40

---Places the camera.
---@param options CameraOptions
function World:camera(options) end

---@class BodyHinge
---@field axis Vector|Body|Tool along which it lies: {0, 0, 1} points at you, as of a lever, {0, 1, 0} stands upright, as of a door; when it points at you, angles grow counter-clockwise; -1 to 1
---@field at? Vector|Body|Tool a place that the axis passes through, at most 100 m from the body; where the body is by default; in metres, -10000 to 10000
---@field inertia number how hard it is to turn, with all that hangs on it; a body with a mass is harder to turn on a support farther from its middle; in kilogram square metres, 0.0001 to 1000000
---@field friction? number the torque that brakes it; in newton metres, 0 to 1000000; default 0
---@field lowest? number it turns no further; no end by default; in degrees, -1000000 to 1000000
---@field highest? number it turns no further; no end by default; in degrees, -1000000 to 1000000
---@field load? number a weight that hangs on it; in newtons, 0 to 1000000; default 0
---@field load_at? Vector|Body|Tool where it hangs at first, at most 100 m from the body; where the body is by default; in metres, -10000 to 10000

---@class BodyJoint
---@field kind string a hinge turns about its axis, a slider moves along it, a ball turns every way about its place, a rod holds two places as far apart as they are, fixed is glued; "hinge", "slider", "ball", "fixed" or "rod"
---@field to? string the name of a rigid body that was declared before; the world by default
---@field at? Vector|Body|Tool where it is; of a rod its end on the other body; where the body is by default; in metres, -10000 to 10000
---@field end_at? Vector|Body|Tool of a rod: its end on this body; where the body is by default; in metres, -10000 to 10000
---@field axis? Vector|Body|Tool of a hinge or slider: {0, 0, 1} points at you, {0, 1, 0} stands upright; -1 to 1; default {0, 0, 1}
---@field lowest? number it goes no further; no end by default; in degrees, metres of a slider, -10000 to 0
---@field highest? number it goes no further; no end by default; in degrees, metres of a slider, 0 to 10000
---@field speed? number of its motor; in degrees or metres per second, -10000 to 10000; default 0
---@field force? number that its motor has; 0 is no motor; in newtons, newton metres of a hinge, 0 to 10000; default 0
---@field friction? number what brakes it; in newtons, newton metres of a hinge, 0 to 10000; default 0

---@class BodyOptions
---@field name string unique; how the lesson calls it, never the learner
---@field noun? string English noun, as answers give it; the name by default, "" for scenery that no answer names; seen beside a movable body, and beside a solid one where it is not just its name; of at most 64 letters
---@field model? string model to draw, see Models; the name by default
---@field radius? number in metres, 0.001 to 10; default 0.05
---@field scale? number how large a thing that can't be touched is drawn, times its model; 0.01 to 100; default 1
---@field mass? number the true mass; in kilograms, 0 to 10000; default 1
---@field exaggeration? number felt weight / true weight, before all are made to fit the arm; 0 to 100; default 1
---@field movable? boolean may fall, be caught and be held; default false
---@field solid? boolean can be touched; default false
---@field material? Material|string what a solid body is made of, see Materials: "wood", or what world:material gave
---@field rounded? boolean a solid body's facets are felt as one, even over bends of up to its crease; default false
---@field crease? number of a rounded body: an edge that bends more than this stays sharp; in degrees, 0 to 180; default 30
---@field visible? boolean is seen from the start; default false
---@field at? Vector|Body|Tool where it is at first; in metres, -10000 to 10000; default {0, 0, 0}
---@field drag_area? number drag coefficient × cross-section, for falling in air; in square metres, 0 to 10; default 0
---@field hinge? BodyHinge an axis that a solid body turns about, pushed by the hand; while it is, arm, force and torque are drawn
---@field size? Vector|Body|Tool edges of a body with model = "box": width, height, depth; twice the radius by default; in metres, 0 to 10
---@field about? string what is said of a solid body when it is first touched, of a movable one when it is first caught, while no question is open; of at most 300 letters
---@field boxes? table[] what a body with model = "box" is made of instead of one: a list of { at = {x, y, z}, size = {x, y, z} }, from the body's place; up to 200, as of a house or a maze
---@field rigid? boolean a thing with a mass that lies, falls, is pushed, gripped with the button, lifted and stacked; can be touched, and is seen unless visible = false; default false
---@field felt_model? string model that the hand feels instead of the one that is drawn; of a box or a ball with its size or radius
---@field felt_shape? string what the hand feels of that model, as large as it reaches: a ball, a box, a cylinder or capsule about the axis across which it is roundest, all without facets, or its hull; by default a ball is one, and others are as they are; "box", "ball", "cylinder", "capsule", "hull" or "mesh"
---@field simulated_model? string model that rigid bodies meet instead of the one that is felt, as a simple one of many triangles
---@field shape? string what a rigid body, or a solid one among them, collides as; by default a box or a ball as its model, else the hull of its model; mesh is the model itself with its hollows, as of a ring or a bowl; "box", "ball", "cylinder", "capsule", "hull" or "mesh"
---@field density? number of a rigid box or ball, instead of its mass: wood 600, water 1000, iron 7900; in kilograms per cubic metre, 1 to 25000
---@field joint? BodyJoint what a rigid body hangs on

---Declares a thing.
---@param options BodyOptions
---@return Body
function World:body(options) end

---@class BucketOptions
---@field model? string model to draw, see Models; default bucket
---@field radius? number of the opening; in metres, 0.001 to 10; default 0.11
---@field depth? number in metres, 0.001 to 10; default 0.14
---@field holds? integer movable bodies at once; felt weights are scaled so that so many fit the arm; 1 to 8; default 1

---Puts a bucket on the tool; movable bodies that fall into it are caught. Among rigid bodies it is one itself, which the hand holds: they fall in, lie in it, weigh, slide and fall out again; a light one of 50 grams, which holds what has room.
---@param options BucketOptions
function World:bucket(options) end

---@class SpringOptions
---@field name? string "spring1", "spring2" … by default
---@field at Vector|Body|Tool where it pulls to; in metres, -10000 to 10000
---@field stiffness number in newtons per metre, 0 to 2000
---@field damping? number in newton seconds per metre, 0 to 50; default 0

---Declares a spring that pulls the hand. It is on from the start.
---@param options SpringOptions
---@return Force
function World:spring(options) end

---@class ViscosityOptions
---@field name? string "viscosity1", "viscosity2" … by default
---@field damping number honey is about 20; in newton seconds per metre, 0 to 50

---Declares a thickness of the air that brakes the hand. It is on from the start.
---@param options ViscosityOptions
---@return Force
function World:viscosity(options) end

---@class MagnetOptions
---@field name? string "magnet1", "magnet2" … by default
---@field at Vector|Body|Tool where it pulls to; in metres, -10000 to 10000
---@field force number the strongest pull; in newtons, 0 to 10
---@field range? number distance of the strongest pull; in metres, 0.001 to 10; default 0.1

---Declares a magnet that pulls the hand. It is on from the start.
---@param options MagnetOptions
---@return Force
function World:magnet(options) end

---@class HandTool
---@field shape? string what it is like; it stands upright; "ball", "box", "capsule" or "cylinder"; default cylinder
---@field model? string a model instead, in its own size, held at its origin; sphere, box and the planets are as large as the radius says
---@field radius? number of a ball, a capsule or a cylinder; a box is twice so wide and deep; other models have none; in metres, 0.001 to 1; default 0.02
---@field length? number from end to end, a capsule's round ends included; a ball and a model have none; in metres, 0.002 to 2; default 0.1
---@field mass? number as the hand feels it near a body; in free air nothing is felt; not with massless; in kilograms, 0.005 to 1; default 0.02
---@field stiffness? number of the spring between hand and tool; in newtons per metre, 50 to 2000; default 500
---@field turn_stiffness? number of the spring that turns it as the hand turns; by default as stiff at its far end as the other spring; what is felt of it is at most 0.3 newton metres, and less where the program is told to be gentler; in newton metres per radian, 0.001 to 10
---@field voxel? number side of the cubes that bodies are made of for it; smaller follows their shape more closely and takes more memory: at most 480 along a body and 64 million in all; fine enough for each body by default, and for all together; in metres, 0.0001 to 1
---@field points? integer on its surface; more follow it more closely and take more time; by default 2000, and for voxel_sampling one a voxel of the tool, as far as a step has time for them: with fewer it pushes sideways beside edges; 100 to 200000
---@field method? string how it is kept outside bodies, by the name of the method: points on it by the distance to their surface, or by cubes that they are made of; or by planes that a few clusters of contact lie on, which hold even where contact is found late (implicit_penalty); or all of its triangles, which never get into theirs, however thin they are, and which alone feel the friction and the texture of their materials (god_object: mass, points and voxel say nothing then); "field_sampling", "voxel_sampling", "implicit_penalty" or "god_object"; default field_sampling
---@field massless? boolean it has no mass of its own: nothing smooths what it meets; default false
---@field integrator? string how it is moved on; all but backward_euler want a heavy tool and a soft spring; not with massless; "explicit_euler", "semi_implicit_euler", "verlet", "runge_kutta_4" or "backward_euler"; default backward_euler
---@field rounded? boolean its facets are felt as one even surface, as far as its creases; for god_object; default false
---@field crease? number of a rounded tool: an edge that bends more than this stays sharp; in degrees, 0 to 180; default 30
---@field contact? string of implicit_penalty: how it is found where the tool is near a body: points on it by the distance to the surface, or its triangles and theirs by levels of detail, as finely as can be felt, which take some seconds to make the first time (levels: voxel and points say nothing then); "fields" or "levels"; default fields
---@field detail? number of contact = "levels": what may be felt as one; 0 is as fine as the meshes, and so is the default beside a budget; nothing gets through, however coarse it is; in of the tool's size, 0 to 0.2; default 0.025
---@field budget? number of contact = "levels": how long finding contacts may take in each step of a live run, as finely as there is time, and no finer than the detail; half a step by default; in microseconds, 20 to 500
---@field contact_model? string of implicit_penalty: how what was found pushes until it is found anew: each cluster as a plane that never pulls, or by the force and its slopes there, which go on as straight as they began; "planes" or "linearised"; default planes

---@class HandOptions
---@field centre? Vector|Body|Tool where the middle of the arm's reach lies; in metres, -10000 to 10000; default {0, 0.3, 0}
---@field scale? number metres in the scene for one metre of a hand that reaches 20 cm each way; one that reaches less gets more; 0.01 to 100; default 1
---@field rate? number how often forces are computed; what is stiff or rings wants more, a slow computer has time for less; in hertz, 500 to 5000; default 1000
---@field velocity? string how the hand's speed is found from its places, by the name of the method: what damps and sounds goes by it; "filtered_difference", "adaptive_window", "finite_difference" or "kalman"; default adaptive_window
---@field structure? string of proxy = "god_object" with a point: how the triangle that it meets is found; where it goes is the same with both; "bounding_tree" or "h_collide"; default bounding_tree
---@field proxy? string what solid bodies are touched with, by the name of its method; what the scene needs by default: friction_cone where something has friction; "god_object", "virtual_proxy" or "friction_cone"
---@field cursor? string the shape that touches; a ball is for virtual_proxy and friction_cone, the others for friction_cone alone, and turn as the hand does, without a torque; a hull is that of cursor_model; "point", "ball", "box", "capsule", "cylinder" or "hull"; default point
---@field cursor_model? string model, in its own size, whose hull is the cursor: what is tightly wrapped round it, without its hollows
---@field cursor_size? number its radius, or half its side; a capsule and a cylinder are so long to each side, a capsule without its round ends; a hull has the size of its model; in metres, 0.0005 to 1; default 0.005
---@field tool? HandTool what the hand holds instead of a cursor: a thing with a shape, felt with force and torque, that stays outside solid bodies, at most 16 of them, without a material; where the hand is pressed in, a pale ghost of it shows where the hand is; a hand that cannot turn holds it upright; no bucket goes with it
---@field needed? boolean of a second hand: without a device for it the lesson is not played; default false

---Says where the hand works in the scene. With hands = 2 in lesson { … } a second call declares another hand, with a place, cursor and loop of its own: two fingers, or both hands of a learner. Where there is one device the second one is not there (hand.there), unless it is needed. Two hands go with solid and rigid bodies and declared forces; bucket, kite, hinges, movable bodies and the lesson's own force are for one. What is touched is heard of the first.
---@param options HandOptions
---@return Hand
function World:hand(options) end

---Declares the lesson's own force on the hand, computed 60 times a second and carried on in between by its slope; a torque by its slope in place alone. It comes at 50 newtons a second at most, and more slowly when it is steeper than 2000 newtons per metre.
---@param compute function function(tool): gives three newtons from tool.x, .y, .z, .vx, .vy, .vz; or six numbers, the last three a torque in newton metres
function Hand:force(compute) end

---@class MaterialSaturation
---@field force? number the most that its spring gives, however deep it is pressed; in newtons, 0.2 to 10
---@field linear_range? number so deep it is an even spring, then it yields more and more; by default up to half the force; in metres, 0 to 0.9

---@class MaterialTexture
---@field image? string PNG or JPEG beside the lesson, such as "felt.jpg": dark is low, light is high; of at most 48 letters
---@field grooves? number straight grooves instead, so far apart; in metres, 0.0001 to 1
---@field bumps? number random bumps instead, at most so wide; in metres, 0.0001 to 1
---@field size? number width of the whole picture on the surface; in metres, 0.0001 to 100; default 0.05
---@field height? number from the deepest valley to the highest peak; in metres, 1e-07 to 0.01
---@field strength? number how strongly it is felt; 1 is as it is, 0 is smooth; 0 to 100
---@field law? string how it is felt: the surface leans against each slope, or pushes sideways, or is carved; "perturbed_normal", "lateral" or "height_offset"

---@class MaterialTap
---@field kind? string what a tap adds, by the name of its law: a constant force for a moment, a force that rings, or the force that makes the handle itself ring; "none", "fixed_pulse", "decaying_sinusoid" or "acceleration_matching"
---@field frequency? number of the ringing; in hertz, 5 to 1000
---@field time? number until it has died away to a third; in seconds, 0.0005 to 0.2
---@field strength? number of a pulse, or of the ringing at first; in newtons for each metre a second, 0 to 100
---@field acceleration? number of acceleration_matching: of the handle at first; in metres per second squared for each metre a second, 0 to 10000
---@field length? number of a fixed_pulse; in seconds, 0.001 to 0.1

---@class MaterialOptions
---@field name string unique; what it is called
---@field like? string a material that it begins as, see Materials; what is not said here is that one's
---@field stiffness? number of its spring; a cushion is about 100, and an arm holds some 500 to 1000; what it can't hold is felt softer or refused; in newtons per metre, 10 to 5000
---@field damping? number how much it swallows; in newton seconds per metre, 0 to 50
---@field saturation? MaterialSaturation a spring that yields, as of dough or a pillow
---@field friction? number what holds a resting hand, in parts of how hard it presses; metal 0.15, wood 0.54, rubber 1; 0 to 5
---@field sliding_friction? number the same while it slides; 0.8 of friction by default; 0 to 5
---@field viscous_friction? number what brakes the hand besides, the faster it slides the more, as on something wet or greasy; none by default; in newton seconds per metre, 0 to 20
---@field texture? MaterialTexture its relief
---@field tap? MaterialTap how it rings when it is tapped

---Makes a material for bodies: out of another one, out of numbers, or out of a picture.
---@param options MaterialOptions
---@return Material
function World:material(options) end

---Takes everything out of the bucket.
function World:release() end

---Shows an instruction.
---@param text string one instruction; "" clears it; of at most 1000 letters
function World:caption(text) end

---Asks a question that L:question declared; L:answered tells the answer.
---@param question string the name of a question; of at most 1000 letters
function World:ask(question) end

---Sets the score that is shown.
---@param score integer -1000000 to 1000000
function World:score(score) end

---Begins a level.
---@param level integer 0 to 99
---@param title? string what the level is called; of at most 200 letters
function World:level(level, title) end

---Plays a sound.
---@param name string see Sounds; e.g. "pop"
function World:sound(name) end

---@class Show_handOptions
---@field at Vector|Body|Tool where its first finger's tip is; in metres, -10000 to 10000

---Shows the program's own hand there, a white glove: it shows what to do, and touches nothing.
---@param options Show_handOptions
function World:show_hand(options) end

---Takes the program's own hand away.
function World:hide_hand() end

---@class FinishOptions
---@field stars integer how well it went; 0 to 3

---Ends the lesson.
---@param options FinishOptions
function World:finish(options) end

---All bodies, in the order they were declared.
---@return Body[]
function World:bodies() end

---The body of that name or noun.
---@param name string the body's name, or its noun when no other body has it; of at most 1000 letters
---@return Body
function World:find(name) end

---What the hand holds.
---@return Tool
function World:tool() end

---Other lessons are entered from here: world.lessons has them, world:enter goes there, and who leaves one comes back. Nothing of a room itself is kept as progress.
function World:room() end

---Leaves a room for another lesson.
---@param lesson? string its name in world.lessons; "" is the list of all; of at most 1000 letters
function World:enter(lesson) end

---@class DropOptions
---@field at? Vector|Body|Tool where it is now by default; in metres, -10000 to 10000
---@field velocity? Vector|Body|Tool at first; in metres per second, -1000 to 1000; default {0, 0, 0}

---Lets it fall.
---@param options DropOptions
function Body:drop(options) end

---@class PlaceOptions
---@field at? Vector|Body|Tool where it is now by default; in metres, -10000 to 10000

---Puts it somewhere, where it stays; a rigid body falls from there. Some body of the lesson must be movable or it rigid. A solid body that is put where the hand's tool is pushes the tool out of itself, so put it beside.
---@param options PlaceOptions
function Body:place(options) end

---Takes it out of the scene. Some body of the lesson must be movable or it rigid.
function Body:hide() end

---Lays it into the tool, so that its weight is felt.
function Body:hold() end

---Shows beside it what was felt of it, as an arrow like the hand's, while it stands there.
---@param newtons? number 0 takes it away; in newtons, 0 to 1000; default 0
function Body:mark(newtons) end

---Lights it up. Above the scene stand as many signs as bodies are offered or lit, hidden ones too, those of lit ones filled, and how many they are.
---@param light string "offered": it may be chosen, a line goes round it; "lit": it shines; "off", "offered" or "lit"
function Body:light(light) end

---Lays a cloth over it: it is not seen, and felt as before.
function Body:cover() end

---Takes the cloth away.
function Body:uncover() end

---@class TurnOptions
---@field angle? number it is there at once; in degrees, -1000000 to 1000000
---@field spin? number it turns so fast from now on, until something brakes it; in degrees per second, -5000 to 5000
---@field at? Vector|Body|Tool a place that its axis passes through from now on, for a body where it was declared; at most 100 m from there; in metres, -10000 to 10000
---@field load? number the weight that hangs on it from now on; in newtons, 0 to 1000000

---Sets how a body on a hinge stands. When its axis points at you, angles grow counter-clockwise; they stay between its lowest and highest.
---@param options TurnOptions
function Body:turn(options) end

---Switches it on, as it is when it is declared.
function Force:on() end

---Switches it off; it fades.
function Force:off() end

---@class MoveOptions
---@field at Vector|Body|Tool where it pulls to from now on; in metres, -10000 to 10000

---Moves a spring or a magnet.
---@param options MoveOptions
function Force:move(options) end

---Weakens it.
---@param factor number 1 as declared, 0 nothing; 0 to 1
function Force:strength(factor) end

---@class KiteOptions
---@field shape? string a diamond at first; "diamond", "delta", "sled" or "box"
---@field height? number from foot to top, 0.8 at first; bridle and knot are made for it; in metres, 0.1 to 5
---@field width? number unfolded, 0.75 at first, of a box 0.4; in metres, 0.1 to 5
---@field fold? number how far each half is bent back, 14 at first; a sled's keels outwards; in degrees, 0 to 57
---@field cloth? string nylon at first; from the lightest: silk, tissue, plastic, cellophane, nylon, paper; "plastic", "tissue", "nylon", "paper", "silk" or "cellophane"
---@field spar? string balsa at first; skewers are a little lighter, birch and tube five times as heavy; "balsa", "birch", "tube" or "skewer"
---@field bridle? number the string from the foot over the knot to the top; 1.25 times the height at first; in metres, 0.1 to 50
---@field knot? number where on the bridle the line is tied, from the foot; 0.85 times the height at first. Lower, the kite stands steeper in the wind; in metres, 0 to 50
---@field tail? number how long it is; 2 at first, 0 for none; in metres, 0 to 50
---@field line? number let out at first; in metres, 5 to 200; default 20
---@field strength? number the line breaks above it; in newtons, 1 to 1000000; default 150
---@field stretch? number what would make the line twice as long; stretch / 5 times felt times the hand's scale at most 2000; in newtons, 10 to 1000000; default 500
---@field segments? integer pieces that the line is computed in; 1 to 64; default 16
---@field felt? number newtons in the hand for a newton of the line; where the site allows less than 5 N, less in the same measure; 0.01 to 10; default 1
---@field seen? number drawn so many times larger than it is, for it is far away; 1 to 10; default 1
---@field elevation? number how steeply the line rises when it is launched; in degrees, 0 to 85; default 40

---Declares a kite on a line that the hand holds. It flies from the start. The reel is the mouse's wheel, or the hand's buttons: the first lets line out, the second takes it in.
---@param options KiteOptions
---@return Kite
function World:kite(options) end

---@class WindOptions
---@field speed? number 10 metres above the ground; less below; in metres per second, 0 to 60; default 6
---@field gusts? number 0 is a steady wind, 1 as it usually is, 4 wild; 0 to 4; default 0
---@field towards? Vector|Body|Tool the direction it blows to, along the ground; -1 to 1; default {1, 0, 0}
---@field over? string what it comes over: the rougher, the less near the ground; "water", "grass", "bushes" or "town"; default grass

---Declares the wind for the kite.
---@param options WindOptions
function World:wind(options) end

---Changes how fast the wind blows, at once; its direction and gusts stay.
---@param speed number 10 metres above the ground; in metres per second, 0 to 60
function World:wind_speed(speed) end

---@class BuildOptions
---@field shape? string a diamond at first; "diamond", "delta", "sled" or "box"
---@field height? number from foot to top, 0.8 at first; bridle and knot are made for it; in metres, 0.1 to 5
---@field width? number unfolded, 0.75 at first, of a box 0.4; in metres, 0.1 to 5
---@field fold? number how far each half is bent back, 14 at first; a sled's keels outwards; in degrees, 0 to 57
---@field cloth? string nylon at first; from the lightest: silk, tissue, plastic, cellophane, nylon, paper; "plastic", "tissue", "nylon", "paper", "silk" or "cellophane"
---@field spar? string balsa at first; skewers are a little lighter, birch and tube five times as heavy; "balsa", "birch", "tube" or "skewer"
---@field bridle? number the string from the foot over the knot to the top; 1.25 times the height at first; in metres, 0.1 to 50
---@field knot? number where on the bridle the line is tied, from the foot; 0.85 times the height at first. Lower, the kite stands steeper in the wind; in metres, 0 to 50
---@field tail? number how long it is; 2 at first, 0 for none; in metres, 0 to 50

---Makes it anew with what is given changed, and launches it on as much line as before.
---@param options BuildOptions
function Kite:build(options) end

---Launches it again, on the whole line that is let out.
---@param elevation? number how steeply the line rises at first; as declared by default; in degrees, 0 to 85
function Kite:fly(elevation) end

---Lets line out or takes it in, at 2 metres a second.
---@param length number of line, at most four times what was let out at first; in metres, 5 to 200
function Kite:reel(length) end

---Cuts the line at the kite, until kite:fly ties it again.
function Kite:cut() end

---Shows lift, drag, weight and tension as arrows, or hides them.
---@param shown? boolean false hides them; default true
function Kite:show_forces(shown) end


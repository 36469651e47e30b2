// Copyright the limpet authors. GPL-3.0-or-later.
//
// The command `limpet`: arguments in, exit code out. What each command does is in command_*.cpp.
#include <fcntl.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <exception>
#include <functional>
#include <iostream>
#include <limpet/app/arguments.hpp>
#include <limpet/app/commands.hpp>
#include <limpet/drawing/page.hpp>
#include <limpet/geometry/predicates.hpp>
#include <limpet/io/error.hpp>
#include <limpet/kinematics/urdf.hpp>
#include <limpet/simulation/mesh.hpp>
#include <limpet/simulation/shapes.hpp>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>

namespace {

using namespace limpet::app;
using Command = std::function<int()>;

/// Options with commas in them (x,y,z) are taken as text and read by our own parsers.
CLI::Option* text_option(CLI::App& app, const std::string& names, const std::string& type,
                         const std::string& help, const std::function<void(const std::string&)>& take) {
  return app.add_option_function<std::string>(names, take, help)->type_name(type);
}

CLI::Option* length_option(CLI::App& app, const std::string& name, const std::string& help, bool zero,
                           const std::function<void(double)>& take) {
  return text_option(app, name, "LENGTH", help,
                     [name, zero, take](const std::string& text) { take(parse_length(name, text, zero)); });
}

template <class Arguments>
std::shared_ptr<Arguments> make_command(CLI::App& app, Command& chosen) {
  auto args = std::make_shared<Arguments>();
  app.parse_complete_callback([args, &chosen] { chosen = [args] { return run(*args); }; });
  return args;
}

void add_quiet_and_json(CLI::App& app, bool& quiet, std::string* json) {
  app.add_flag("-q,--quiet", quiet, "Say nothing but errors and warnings");
  if (json) app.add_option("--json", *json, "Write a summary there, as JSON (- for standard output)");
}

void add_model(CLI::App& root, Command& chosen) {
  auto& app = *root.add_subcommand("model", "Build a model from a scan, read in order, in sets");
  const auto args = make_command<ModelArguments>(app, chosen);
  app.add_option("SCAN", args->scan, "A scan: .ply, .pcd, .xyz or .pwn (- for standard input)")->required();
  app.add_option("-o,--output", args->models,
                 "Where to write the model: .limpet, .off, .ply, .obj, .stl, .glb, .vtp")
      ->required()
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->type_name("MODEL");
  text_option(app, "--resolution", "A[,B]",
              "Gaps smaller than A + B range are not represented (default: by the scan)",
              [args](const std::string& text) { args->resolution = parse_resolution("--resolution", text); });
  text_option(app, "--angle", "DEGREES", "Angles smaller than this are not told apart (default 10)",
              [args](const std::string& text) {
                args->angle_deg = parse_length("--angle", text, false);
                if (args->angle_deg >= 90) throw UsageError("--angle " + text + ": must be less than 90");
              });
  text_option(app, "--noise", "A[,B[,C]]",
              "Standard deviation of a reading along its axis: A + B range + C range² (default: by the scan)",
              [args](const std::string& text) { args->noise = parse_noise("--noise", text); });
  length_option(app, "--tolerance",
                "How far from its plane a surface may be (default: the larger of three times the noise and a "
                "fifth of the resolution)",
                true, [args](double length) { args->tolerance = length; });
  app.add_option("--set-size", args->set_size, "Sensor points in a set (default 26)")
      ->check(CLI::Range(1, 1'000'000));
  text_option(
      app, "--order", "ORDER",
      "In which points are modelled: curve (from neighbour to neighbour: faster, and better; default) or "
      "arrival (as they come: for streams without an end)",
      [args](const std::string& text) {
        if (text != "curve" && text != "arrival")
          throw UsageError("--order " + text + ": give curve or arrival");
        args->in_arrival_order = text == "arrival";
      });
  app.add_option("--order-memory", args->order_memory,
                 "MB of points to be put in order that are held in memory; the rest is on disk (default 256)")
      ->check(CLI::Range(1, 1'000'000));
  const auto viewpoint =
      text_option(app, "--viewpoint", "X,Y,Z",
                  "Where the sensor stood, for scans without axes and normals (default: by neighbours)",
                  [args](const std::string& text) { args->viewpoint = parse_vector("--viewpoint", text); });
  app.add_flag("--orient", args->orient, "Find that side by neighbours, whatever the scan says of it")
      ->excludes(viewpoint);
  app.add_option("--initial", args->initial, "Faces known beforehand: they share edges, and stay as they are")
      ->type_name("MESH");
  app.add_flag("--open", args->open, "Leave all edges open: no shared edges, no corner vertices");
  text_option(
      app, "--redundancy", "N,F",
      "A segment of fewer than N points, and of less than the part F of another's, that shares no edge "
      "with it is redundant (default 20,0.05)",
      [args](const std::string& text) { args->redundancy = parse_redundancy("--redundancy", text); });
  text_option(app, "--rules", "RULES", "Update rules: limpet, thesis, names to keep, or -names to leave out",
              [args](const std::string& text) {
                try {
                  args->rules = limpet::model::Rules::parse(text);
                } catch (const std::invalid_argument& error) {
                  throw UsageError(error.what());
                }
              });
  app.add_option("--labels", args->labels, "Write the segment each record went to, one a line (0: none)");
  app.add_option("--check-every", args->check_every, "Let the oracle judge after every Nth set too")
      ->check(CLI::Range(std::int64_t{1}, std::int64_t{1} << 40));
  app.add_option("--stages", args->stages, "Keep N stages of growth beside the first MODEL, for limpet draw")
      ->check(CLI::Range(1, 64));
  const auto checkpoint =
      app.add_option("--checkpoint", args->checkpoint,
                     "Keep all of the run there, now and then, so that it can go on after whatever ends it")
          ->type_name("FILE");
  app.add_option("--checkpoint-every", args->checkpoint_every, "After every Nth set (default 100000)")
      ->check(CLI::Range(std::int64_t{1}, std::int64_t{1} << 40))
      ->needs(checkpoint);
  app.add_flag("--resume", args->resume,
               "Go on from the checkpoint, if there is one, with the same scan and options")
      ->needs(checkpoint);
  app.add_option("--seed", "Taken for the sake of scripts: modelling has no chance in it")
      ->check(CLI::TypeValidator<std::uint64_t>());
  add_quiet_and_json(app, args->quiet, &args->json);
}

/// A recorded run says all that these options say.
void refuse_with_replay(CLI::App& app, const FollowArguments& args) {
  app.final_callback([&app, &args] {
    if (args.replay.empty()) {
      if (args.scene.empty()) throw UsageError("give a SCENE, or --replay RUN; see limpet follow --help");
      return;
    }
    for (const std::string name :
         {"SCENE", "--record", "--robot", "--package-path", "--avoidance", "--link-sensors", "--strategy",
          "--start", "--initial", "--resolution", "--angle", "--noise", "--encoder-noise", "--redundancy",
          "--max-sets", "--seed"})
      if (app.count(name) > 0)
        throw UsageError("--replay RUN takes no " + name + ": the recorded run is modelled as it was");
  });
}

void add_follow(CLI::App& root, Command& chosen) {
  auto& app = *root.add_subcommand("follow", "Drive a simulated robot over an object until it is modelled");
  const auto args = make_command<FollowArguments>(app, chosen);
  app.add_option("SCENE", args->scene, "A shape, a mesh (.off, .stl, .obj, .ply), or a scene file (.toml)");
  app.add_option("-o,--output", args->models,
                 "Where to write the model: .limpet, .off, .ply, .obj, .stl, .glb, .vtp")
      ->required()
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->type_name("MODEL");
  app.add_option(
         "--robot", args->robot,
         "point (default): the mobile point robot with 26 range finders; arm: the thesis's arm; a URDF "
         "(.urdf) or a robot file (.toml)")
      ->type_name("ROBOT");
  app.add_option("--package-path", args->package_paths,
                 "A folder in which the robot's URDF and meshes are sought; may be given several times")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->type_name("DIR");
  text_option(app, "--strategy", "NAME", "frontier (default) or thesis", [args](const std::string& text) {
    if (text != "frontier" && text != "thesis")
      throw UsageError("--strategy '" + text + "': give frontier or thesis");
    args->strategy =
        text == "thesis" ? limpet::following::Strategy::thesis : limpet::following::Strategy::frontier;
  });
  text_option(app, "--avoidance", "NAME",
              "How an arm's links are kept off the surface: programme (default) or thesis",
              [args](const std::string& text) {
                if (text != "programme" && text != "thesis")
                  throw UsageError("--avoidance '" + text + "': give programme or thesis");
                args->avoidance = text == "thesis" ? limpet::following::Redundancy::thesis
                                                   : limpet::following::Redundancy::programme;
              });
  text_option(app, "--collisions", "WHAT",
              "end (default): a touch of the true surface ends the run and leaves a scene file that comes to "
              "it again; or count",
              [args](const std::string& text) {
                if (text != "end" && text != "count")
                  throw UsageError("--collisions '" + text + "': give end or count");
                args->count_collisions = text == "count";
              });
  text_option(
      app, "--link-sensors", "NAME",
      "What an arm's links are covered with: range finders (range, the default) or proximity switches "
      "(switches)",
      [args](const std::string& text) { args->link_sensors = parse_link_sensors("--link-sensors", text); });
  text_option(app, "--start", "X,Y,Z",
              "Where the control point begins (default: at random, near the surface)",
              [args](const std::string& text) { args->start = parse_vector("--start", text); });
  app.add_option("--initial", args->initial, "Faces known beforehand: they share edges, and stay as they are")
      ->type_name("MESH");
  length_option(app, "--resolution", "Gaps smaller than this are not represented (default: by the object)",
                false, [args](double length) { args->resolution = length; });
  text_option(app, "--angle", "DEGREES", "Angles smaller than this are not told apart (default 10)",
              [args](const std::string& text) {
                args->angle_deg = parse_length("--angle", text, false);
                if (*args->angle_deg >= 90) throw UsageError("--angle " + text + ": must be less than 90");
              });
  length_option(app, "--noise", "Standard deviation of a reading along its axis (default 0)", true,
                [args](double length) { args->noise = length; });
  length_option(app, "--encoder-noise",
                "Standard deviation of the measured positions of the joints (default 0)", true,
                [args](double length) { args->encoder_noise = length; });
  text_option(app, "--redundancy", "N,F", "As for limpet model (default 20,0.05)",
              [args](const std::string& text) { args->redundancy = parse_redundancy("--redundancy", text); });
  app.add_option("--max-sets", args->max_sets, "End after this many sets (default 1000000)")
      ->check(CLI::Range(std::int64_t{1}, std::int64_t{1} << 40));
  app.add_option("--seed", args->seed, "Of all that is random (default 1)");
  app.add_option("--check-every", args->check_every, "Let the oracle judge after every Nth set too")
      ->check(CLI::Range(std::int64_t{1}, std::int64_t{1} << 40));
  app.add_option("--record", args->record, "Record the run there, to be replayed and drawn")
      ->type_name("RUN");
  app.add_option("--page", args->page, "A page of limpet view: what is left open is told with links into it")
      ->type_name("PAGE");
  app.add_option("--replay", args->replay, "Model a recorded run again, instead of following a scene")
      ->type_name("RUN");
  refuse_with_replay(app, *args);
  add_quiet_and_json(app, args->quiet, &args->json);
}

void add_scan(CLI::App& root, Command& chosen) {
  auto& app = *root.add_subcommand("scan", "Simulate a range scan of a mesh");
  const auto args = make_command<ScanArguments>(app, chosen);
  std::string shapes;
  for (const auto& name : limpet::simulation::shape_names()) shapes += (shapes.empty() ? "" : ", ") + name;
  app.add_option("MESH", args->mesh, "A mesh (.off, .stl, .obj, .ply) or a shape: " + shapes)->required();
  app.add_option("-o,--output", args->scan, "Where to write the scan: .ply or .xyz")->required();
  app.add_option("--points", args->points, "Points wanted (default 100000)")
      ->check(CLI::Range(std::int64_t{1}, std::int64_t{1'000'000'000}));
  app.add_option("--order", args->order, "raster, turning, shuffled or sampled (default raster)");
  text_option(app, "--noise", "A[,B]", "Standard deviation along the axis: A + B times the range",
              [args](const std::string& text) {
                const limpet::survey::NoiseLaw noise = parse_noise("--noise", text);
                args->noise = noise.fixed;
                args->noise_per_range = noise.per_range;
              });
  app.add_option("--outliers", args->outliers, "Fraction of points that are anywhere")
      ->check(CLI::Range(0.0, 1.0));
  app.add_option("--seed", args->seed, "Of the random numbers (default 1)");
  app.add_option_function<std::vector<std::string>>(
         "--viewpoint",
         [args](const std::vector<std::string>& texts) {
           for (const auto& text : texts) args->viewpoints.push_back(parse_vector("--viewpoint", text));
         },
         "Where the sensor stands; may be given again (default: around the mesh)")
      ->type_name("X,Y,Z")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  app.add_flag("--faces", args->faces, "Write the true face of each point too");
  app.add_flag("--ranges", args->ranges, "Write how far each point was from its sensor, too");
  app.add_flag("--ascii", args->ascii, "Write text, not binary");
  add_quiet_and_json(app, args->quiet, nullptr);
}

void add_check(CLI::App& root, Command& chosen) {
  auto& app = *root.add_subcommand(
      "check", "Judge a model by its laws, and by its scan; exit 0 only if nothing is broken or invented");
  const auto args = make_command<CheckArguments>(app, chosen);
  app.add_option("MODEL", args->model, "A native model file, .limpet")->required();
  const auto scan =
      app.add_option(
             "--scan", args->scan,
             "The scan it was made of: is all of the model supported by readings, and none of it seen "
             "through?")
          ->type_name("SCAN");
  const auto viewpoint =
      text_option(app, "--viewpoint", "X,Y,Z", "Where the scan's sensor stood, as for limpet model",
                  [args](const std::string& text) { args->viewpoint = parse_vector("--viewpoint", text); })
          ->needs(scan);
  app.add_flag("--orient", args->orient, "Orient the scan by neighbours, as for limpet model")
      ->needs(scan)
      ->excludes(viewpoint);
  app.add_option("--page", args->page, "A page of limpet view: what is found is told with links into it")
      ->type_name("PAGE");
  app.add_option("--seed", "Taken for the sake of scripts")->check(CLI::TypeValidator<std::uint64_t>());
  add_quiet_and_json(app, args->quiet, &args->json);
}

/// Options of `compare` that ask for --labels.
void add_labels(CLI::App& app, CompareArguments& args) {
  LabelArguments& labels = args.labels;
  const auto flag = app.add_flag("--labels", args.by_labels,
                                 "Compare regions, point by point, by the labels of each record of the scan");
  app.add_option("--column", labels.column, "The column of the scan TRUTH with the labels (default: by name)")
      ->needs(flag);
  text_option(app, "--none", "LABELS",
              "True labels that are no region, as in 0..9,255; negative ones are none",
              [&labels](const std::string& text) { labels.none = parse_ranges("--none", text); })
      ->needs(flag);
  app.add_option("--polygons", labels.polygons, "The native model: segments that are no polygons are none")
      ->needs(flag);
  app.add_option("--overlap", labels.overlap, "Share of a region that must agree (default 0.8)")
      ->check(CLI::Range(0.5, 1.0))
      ->needs(flag);
  const CLI::Range count(std::int64_t{1}, std::int64_t{1} << 40);
  app.add_option("--min-true", labels.min_true, "Points of the smallest true region that counts (default 1)")
      ->check(count)
      ->needs(flag);
  app.add_option("--min-found", labels.min_found, "Points of the smallest found one (default 1)")
      ->check(count)
      ->needs(flag);
  app.add_option("--min-correct", labels.min_correct,
                 "Exit 1 unless this share of the true regions is correct, 0 to 1")
      ->check(CLI::Range(0.0, 1.0))
      ->needs(flag);
}

void add_compare(CLI::App& root, Command& chosen) {
  auto& app = *root.add_subcommand(
      "compare", "Distances between a model and the truth, both ways; or, by labels, regions found and true");
  const auto args = make_command<CompareArguments>(app, chosen);
  app.add_option("MODEL", args->model,
                 "A model: .limpet, .off, .ply, .obj or .stl; with --labels, the segment of each record")
      ->required();
  app.add_option("TRUTH", args->truth,
                 "A mesh, or the name of a shape; with --labels, true labels: a list, or the scan itself")
      ->required();
  length_option(app, "--max-distance", "Exit 1 if any distance, either way, is above this", true,
                [args](double length) { args->max_distance = length; });
  text_option(app, "--faces", "exact", "Exit 1 unless there are as many polygons as true faces",
              [args](const std::string& text) {
                if (text != "exact") throw UsageError("--faces '" + text + "': give exact");
                args->faces_exact = true;
              });
  add_labels(app, *args);
  app.add_option("--seed", "Taken for the sake of scripts")->check(CLI::TypeValidator<std::uint64_t>());
  add_quiet_and_json(app, args->quiet, &args->json);
}

void add_draw(CLI::App& root, Command& chosen) {
  auto& app = *root.add_subcommand("draw", "Draw models, without a display; several as stages of growth");
  const auto args = make_command<DrawArguments>(app, chosen);
  app.add_option("MODEL", args->models,
                 "Native model files, .limpet; also recorded runs of limpet follow, meshes and shapes")
      ->required();
  auto* stages = app.add_option("--stages", args->stages.count,
                                "Stages to draw of a recorded run, with its path (default 4)")
                     ->check(CLI::Range(1, 64));
  app.add_option("--at", args->stages.at, "Instead of stages, draw a recorded run after its Nth set")
      ->type_name("N")
      ->check(CLI::Range(std::int64_t{1}, std::int64_t{1} << 40))
      ->excludes(stages);
  app.add_flag_callback(
      "--no-robot", [args] { args->stages.with_robot = false; },
      "Of an arm's run: leave out the arm, its rays and its switches");
  app.add_option("-o,--output", args->picture, "Where to write the picture: .png or .svg")->required();
  app.add_option("--width", args->width, "Of the sheet, in pixels (default 1600)")
      ->check(CLI::Range(200, 16384));
  app.add_option_function<std::vector<std::string>>(
         "--view",
         [args](const std::vector<std::string>& texts) {
           for (const auto& text : texts) args->views.push_back(parse_vector("--view", text));
         },
         "The direction to look from; may be given again")
      ->type_name("X,Y,Z")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  text_option(app, "--up", "X,Y,Z", "Upwards in the picture (default: z)",
              [args](const std::string& text) { args->up = parse_vector("--up", text); });
  app.add_option("--seed", "Taken for the sake of scripts")->check(CLI::TypeValidator<std::uint64_t>());
  add_quiet_and_json(app, args->quiet, nullptr);
}

void add_view(CLI::App& root, Command& chosen) {
  auto& app =
      *root.add_subcommand("view", "One page that shows a model or plays a run, in any browser, offline");
  const auto args = make_command<ViewArguments>(app, chosen);
  app.add_option("MODEL", args->source, "A native model file, .limpet, or a recorded run of limpet follow")
      ->required();
  app.add_option("-o,--output", args->outputs,
                 "Where to write it: .html; .glb (glTF), .vtp and, of a run, .pvd (ParaView)")
      ->required()
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->type_name("PAGE");
  app.add_option("--truth", args->truth, "Show the true surface, too: a mesh, or the name of a shape")
      ->type_name("MESH");
  app.add_option("--stages", args->stages, "Models in a .pvd (default 100)")->check(CLI::Range(1, 100'000));
  app.add_flag("--times", args->times,
               "Measure the time of each update; such a page has not the same bytes each time");
  app.add_option("--seed", "Taken for the sake of scripts")->check(CLI::TypeValidator<std::uint64_t>());
  add_quiet_and_json(app, args->quiet, nullptr);
}

/// One line, whatever is in it.
int fail(const std::string& message, int code) {
  std::string line = message;
  for (char& c : line) {
    if (static_cast<unsigned char>(c) < ' ' || c == 0x7f) c = ' ';
  }
  std::fprintf(stderr, "limpet: %s\n", line.c_str());
  return code;
}

/// A pipe that is closed, or a file that may not grow, is told of, like any other output that fails; and no
/// file takes the place of a standard stream that is closed.
void take_failing_writes_as_errors() {
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  for (int stream = 0; stream <= 2; ++stream)
    if (::fcntl(stream, F_GETFD) < 0) ::open("/dev/null", O_RDONLY);
}

int parse_and_run(int argc, char** argv) {
  CLI::App app{"Exact planar polyhedral surface models from streams of range readings", "limpet"};
  app.set_version_flag("--version", std::string("limpet " LIMPET_VERSION " (arithmetic: ") +
                                        limpet::geometry::arithmetic() + ")");
  app.require_subcommand(1);
  app.footer(
      "Lengths are in the scan's unit, angles in degrees. Exit codes: 0 done, 1 the result falls short,\n"
      "2 bad usage or damaged input. 'limpet COMMAND --help' says more.");
  Command command;
  add_model(app, command);
  add_follow(app, command);
  add_scan(app, command);
  add_check(app, command);
  add_compare(app, command);
  add_draw(app, command);
  add_view(app, command);
  const auto is_name = [&](const CLI::App* sub) { return sub->get_name() == argv[1]; };
  const auto commands = app.get_subcommands({});
  if (argc > 1 && argv[1][0] != '-' && std::none_of(commands.begin(), commands.end(), is_name)) {
    return fail("there is no command '" + std::string(argv[1]) + "'; see limpet --help", kBadInput);
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) {  // --help, --version
      const int code = app.exit(error);
      if (!std::cout.flush()) throw limpet::io::OutputError("standard output: cannot be written");
      return code;
    }
    const auto chosen = app.get_subcommands();
    const std::string help = chosen.empty() ? "limpet" : "limpet " + chosen.front()->get_name();
    return fail(std::string(error.what()) + "; see " + help + " --help", kBadInput);
  }
  const int code = command();
  if (std::fflush(stdout) != 0) throw limpet::io::OutputError("standard output: cannot be written");
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  take_failing_writes_as_errors();
  try {
    return parse_and_run(argc, argv);
  } catch (const UsageError& error) {
    return fail(error.what(), kBadInput);
  } catch (const limpet::io::InputError& error) {
    return fail(error.what(), kBadInput);
  } catch (const limpet::io::OutputError& error) {
    return fail(error.what(), kBadInput);
  } catch (const limpet::drawing::NoPage& error) {
    return fail(error.what(), kBadInput);
  } catch (const limpet::kinematics::RobotError& error) {
    return fail(error.what(), kBadInput);
  } catch (const limpet::simulation::MeshError& error) {
    return fail(error.what(), kBadInput);
  } catch (const std::bad_alloc&) {
    return fail("there is not enough memory for this input", kBadInput);
  } catch (const std::exception& error) {
    return fail(std::string("a bug in limpet, please report it: ") + error.what(), kFallsShort);
  }
}

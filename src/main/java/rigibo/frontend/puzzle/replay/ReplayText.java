package rigibo.frontend.puzzle.replay;

import rigibo.backend.Pool;
import rigibo.backend.setup.Accuracy;
import rigibo.frontend.puzzle.rules.Act;
import rigibo.frontend.puzzle.rules.Checkpoint;

import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

import java.util.Locale;

/** Writes a recording as the text of a file. */
final class ReplayText {

    private static final JsonMapper JSON = JsonMapper.shared();

    private ReplayText() {}

    static String of(Recording recording) {
        ObjectNode root = document(recording);
        return JSON.writerWithDefaultPrettyPrinter().writeValueAsString(root) + "\n";
    }

    static ObjectNode document(Recording recording) {
        ObjectNode root = JSON.createObjectNode();
        root.put("format", ReplayLoader.FORMAT);
        root.put("game", GameVersion.present());
        root.put("revision", Pool.REVISION);
        level(root.putObject("level"), recording);
        accuracy(root.putObject("accuracy"), recording.replay().accuracy());
        clicks(root.putArray("clicks"), recording);
        ObjectNode hashes = root.putObject("hashes");
        for (Checkpoint checkpoint : recording.checkpoints()) {
            hashes.put(Integer.toString(checkpoint.step()), Hex.of(checkpoint.hash()));
        }
        return root;
    }

    private static void level(ObjectNode node, Recording recording) {
        node.put("id", recording.level().id());
        node.put("title", recording.level().title().in(Locale.ENGLISH));
        node.put("hash", Hex.of(recording.replay().levelHash()));
        recording
                .level()
                .origin()
                .ifPresent(
                        origin ->
                                node.putObject("made")
                                        .put("seed", origin.seed())
                                        .put("generator", origin.generator()));
    }

    private static void accuracy(ObjectNode node, Accuracy accuracy) {
        node.put("substeps", accuracy.substeps());
        node.put("velocityIterations", accuracy.velocityIterations());
        node.put("impacts", accuracy.impacts().name());
        node.put("impactTolerance", accuracy.impactTolerance());
        node.put("search", accuracy.search().name());
        node.put("maxImpactsPerPair", accuracy.maxImpactsPerPair());
        node.put("integrator", accuracy.integrator().name());
        node.put("contactSolver", accuracy.contactSolver().name());
        node.put("correction", accuracy.correction().name());
    }

    private static void clicks(ArrayNode node, Recording recording) {
        for (Act act : recording.replay().acts()) {
            String target = recording.level().isJoint(act.target()) ? "joint" : "body";
            node.addObject().put("step", act.step()).put(target, act.target());
        }
    }
}

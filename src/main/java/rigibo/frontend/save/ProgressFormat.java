package rigibo.frontend.save;

import rigibo.frontend.scene.LevelProgress;
import rigibo.frontend.scene.Progress;

import tools.jackson.databind.JsonNode;
import tools.jackson.databind.node.ObjectNode;

import java.util.OptionalInt;
import java.util.SortedMap;
import java.util.TreeMap;

/** Progress in JSON. Hashes are hexadecimal words, for JSON's numbers need not have 64 bits. */
final class ProgressFormat implements Format<Progress> {

    @Override
    public Progress initial() {
        return Progress.none();
    }

    @Override
    public Progress read(JsonNode json) {
        SortedMap<String, LevelProgress> levels = new TreeMap<>();
        json.required("levels")
                .asObject()
                .properties()
                .forEach(level -> levels.put(level.getKey(), level(level.getValue())));
        return new Progress(levels);
    }

    private static LevelProgress level(JsonNode json) {
        return new LevelProgress(
                Long.parseUnsignedLong(json.required("hash").stringValue(), 16),
                json.required("solved").booleanValue(),
                json.has("fewestClicks")
                        ? OptionalInt.of(json.get("fewestClicks").intValue())
                        : OptionalInt.empty(),
                json.required("failures").intValue());
    }

    @Override
    public void write(Progress progress, ObjectNode json) {
        ObjectNode levels = json.putObject("levels");
        progress.levels().forEach((id, level) -> write(level, levels.putObject(id)));
    }

    private static void write(LevelProgress level, ObjectNode json) {
        json.put("hash", Long.toHexString(level.levelHash()));
        json.put("solved", level.isSolved());
        level.fewestClicks().ifPresent(clicks -> json.put("fewestClicks", clicks));
        json.put("failures", level.failures());
    }

    @Override
    public Progress merged(Progress before, Progress onDisk, Progress own) {
        return own.with(onDisk);
    }
}

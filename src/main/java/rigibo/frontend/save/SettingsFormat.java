package rigibo.frontend.save;

import rigibo.frontend.scene.Settings;

import tools.jackson.databind.JsonNode;
import tools.jackson.databind.node.ObjectNode;

import java.util.Locale;
import java.util.function.Function;

/** Settings in JSON. One that is missing, for it is younger than the file, is as it is at first. */
record SettingsFormat(Settings initial) implements Format<Settings> {

    @Override
    public Settings read(JsonNode json) {
        return new Settings(
                value(json, "language", JsonNode::stringValue, initial.language()),
                value(json, "volume", JsonNode::doubleValue, initial.volume()),
                value(json, "muted", JsonNode::booleanValue, initial.isMuted()),
                value(json, "motion", node -> word(Settings.Motion.class, node), initial.motion()),
                value(json, "detail", node -> word(Settings.Detail.class, node), initial.detail()),
                value(json, "fullScreen", JsonNode::booleanValue, initial.isFullScreen()));
    }

    private static <V> V value(JsonNode json, String name, Function<JsonNode, V> read, V missing) {
        return json.has(name) ? read.apply(json.get(name)) : missing;
    }

    private static <E extends Enum<E>> E word(Class<E> kind, JsonNode node) {
        return Enum.valueOf(kind, node.stringValue().toUpperCase(Locale.ROOT));
    }

    @Override
    public void write(Settings settings, ObjectNode json) {
        json.put("language", settings.language());
        json.put("volume", settings.volume());
        json.put("muted", settings.isMuted());
        json.put("motion", settings.motion().name().toLowerCase(Locale.ROOT));
        json.put("detail", settings.detail().name().toLowerCase(Locale.ROOT));
        json.put("fullScreen", settings.isFullScreen());
    }

    @Override
    public Settings merged(Settings before, Settings onDisk, Settings own) {
        return new Settings(
                later(before, onDisk, own, Settings::language),
                later(before, onDisk, own, Settings::volume),
                later(before, onDisk, own, Settings::isMuted),
                later(before, onDisk, own, Settings::motion),
                later(before, onDisk, own, Settings::detail),
                later(before, onDisk, own, Settings::isFullScreen));
    }

    /** Our own choice where one was made since, for it is the latest; else what the file has. */
    private static <V> V later(
            Settings before, Settings onDisk, Settings own, Function<Settings, V> setting) {
        V chosen = setting.apply(own);
        return chosen.equals(setting.apply(before)) ? setting.apply(onDisk) : chosen;
    }
}

package rigibo.frontend.save;

import rigibo.frontend.document.Value;
import rigibo.frontend.scene.Action;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.KeyBindings;
import rigibo.frontend.scene.Settings;

import tools.jackson.databind.node.ObjectNode;

import java.util.EnumMap;
import java.util.Locale;
import java.util.Map;
import java.util.function.Function;
import java.util.stream.Collectors;

/**
 * Settings in JSON. A setting that is missing, because it is newer than the file, gets its default.
 */
record SettingsFormat(Settings initial) implements Format<Settings> {

    private static final Map<String, Key> FREE =
            KeyBindings.FREE.stream()
                    .collect(Collectors.toMap(SettingsFormat::name, Function.identity()));

    private static String name(Key key) {
        return key.name().toLowerCase(Locale.ROOT);
    }

    @Override
    public Settings read(Value json) {
        return new Settings(
                json.optional("language").word(Settings.LANGUAGES, initial.language()),
                json.optional("volume").number(0, 1, initial.volume()),
                json.optional("muted").truth(initial.isMuted()),
                json.optional("motion").word(Settings.Motion.class, initial.motion()),
                json.optional("detail").word(Settings.Detail.class, initial.detail()),
                json.optional("fullScreen").truth(initial.isFullScreen()),
                json.optional("ghost").truth(initial.hasGhost()),
                json.optional("music").number(0, 1, initial.music()),
                json.optional("text").word(Settings.TextSize.class, initial.text()),
                keys(json.optional("keys")));
    }

    private static KeyBindings keys(Value json) {
        if (json.isThere()) {
            json.object();
        }
        Map<Action, Key> stated = new EnumMap<>(Action.class);
        for (Action action : Action.values()) {
            Value key = json.optional(action.title());
            if (key.isThere()) {
                String name = key.word(FREE.keySet(), name(action.first()));
                stated.put(action, FREE.get(name));
            }
        }
        boolean isSound = KeyBindings.isSound(stated);
        if (!isSound) {
            json.wrong("must give no key to two actions of one place");
        }
        return KeyBindings.completed(isSound ? stated : Map.of());
    }

    @Override
    public void write(Settings settings, ObjectNode json) {
        json.put("language", settings.language());
        json.put("volume", settings.volume());
        json.put("muted", settings.isMuted());
        json.put("motion", settings.motion().name().toLowerCase(Locale.ROOT));
        json.put("detail", settings.detail().name().toLowerCase(Locale.ROOT));
        json.put("fullScreen", settings.isFullScreen());
        json.put("ghost", settings.hasGhost());
        json.put("music", settings.music());
        json.put("text", settings.text().name().toLowerCase(Locale.ROOT));
        ObjectNode keys = json.putObject("keys");
        settings.keys().keys().forEach((action, key) -> keys.put(action.title(), name(key)));
    }

    @Override
    public Settings merged(Settings before, Settings onDisk, Settings own) {
        return new Settings(
                later(before, onDisk, own, Settings::language),
                later(before, onDisk, own, Settings::volume),
                later(before, onDisk, own, Settings::isMuted),
                later(before, onDisk, own, Settings::motion),
                later(before, onDisk, own, Settings::detail),
                later(before, onDisk, own, Settings::isFullScreen),
                later(before, onDisk, own, Settings::hasGhost),
                later(before, onDisk, own, Settings::music),
                later(before, onDisk, own, Settings::text),
                later(before, onDisk, own, Settings::keys));
    }

    /** This game's choice if one was made since, because it is the latest; otherwise the file's. */
    private static <V> V later(
            Settings before, Settings onDisk, Settings own, Function<Settings, V> setting) {
        V chosen = setting.apply(own);
        return chosen.equals(setting.apply(before)) ? setting.apply(onDisk) : chosen;
    }
}

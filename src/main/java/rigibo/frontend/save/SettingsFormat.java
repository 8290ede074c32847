package rigibo.frontend.save;

import rigibo.frontend.document.Value;
import rigibo.frontend.scene.Settings;

import tools.jackson.databind.node.ObjectNode;

import java.util.Locale;
import java.util.function.Function;

/**
 * Settings in JSON. A setting that is missing, because it is newer than the file, gets its default.
 */
record SettingsFormat(Settings initial) implements Format<Settings> {

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
                json.optional("music").number(0, 1, initial.music()));
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
                later(before, onDisk, own, Settings::music));
    }

    /** Our own choice where one was made since, for it is the latest; else what the file has. */
    private static <V> V later(
            Settings before, Settings onDisk, Settings own, Function<Settings, V> setting) {
        V chosen = setting.apply(own);
        return chosen.equals(setting.apply(before)) ? setting.apply(onDisk) : chosen;
    }
}

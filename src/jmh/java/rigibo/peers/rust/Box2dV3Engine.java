package rigibo.peers.rust;

import rigibo.backend.effect.Effects;
import rigibo.lab.engine.Engine;
import rigibo.lab.engine.Line;
import rigibo.lab.engine.Setting;
import rigibo.lab.engine.World;
import rigibo.peers.PeerSettings;

import java.util.List;
import java.util.Optional;

/** Box2D v3: its C code unchanged, with AVX2 instructions if they are found at build time. */
public final class Box2dV3Engine implements Engine {

    static final int NUMBER = 0;

    /** Its manual reduces errors by more substeps only. */
    private static final Setting EIGHT = Setting.of("8 substeps", Line.PEERS);

    private static final Setting SIXTEEN = Setting.of("16 substeps", Line.PEERS);

    @Override
    public Optional<String> missing() {
        return Library.missing();
    }

    @Override
    public String name() {
        return "Box2D " + Library.version(NUMBER);
    }

    @Override
    public List<Setting> settings() {
        return List.of(PeerSettings.DEFAULT, EIGHT, SIXTEEN);
    }

    @Override
    public World world(Effects effects, Setting setting) {
        return new RustWorld(NUMBER, effects, substeps(setting));
    }

    private static int substeps(Setting setting) {
        if (setting.equals(SIXTEEN)) {
            return 16;
        }
        return setting.equals(EIGHT) ? 8 : RustWorld.USUAL_SUBSTEPS;
    }
}

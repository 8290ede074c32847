package rigibo.peers.rust;

import rigibo.backend.effect.Effects;
import rigibo.lab.engine.Engine;
import rigibo.lab.engine.Setting;
import rigibo.lab.engine.World;
import rigibo.peers.PeerSettings;

import java.util.List;
import java.util.Optional;

/** Rapier, on one thread, with its default features. */
public final class RapierEngine implements Engine {

    static final int NUMBER = 1;

    @Override
    public Optional<String> missing() {
        return Library.missing();
    }

    @Override
    public String name() {
        return "Rapier " + Library.version(NUMBER);
    }

    @Override
    public List<Setting> settings() {
        return PeerSettings.all();
    }

    /** The iterations of the solver in its manual are substeps. */
    @Override
    public World world(Effects effects, Setting setting) {
        int substeps = PeerSettings.iterations(setting, RustWorld.USUAL_SUBSTEPS);
        return new RustWorld(NUMBER, effects, substeps);
    }
}

package rigibo.peers.gdx;

import com.badlogic.gdx.Version;
import com.badlogic.gdx.physics.box2d.Box2D;
import com.badlogic.gdx.utils.GdxNativesLoader;

import rigibo.backend.effect.Effects;
import rigibo.lab.engine.Engine;
import rigibo.lab.engine.Setting;
import rigibo.lab.engine.World;
import rigibo.peers.PeerSettings;

import java.util.List;

/** Box2D by libGDX. */
public final class GdxBox2dEngine implements Engine {

    @Override
    public String name() {
        return "gdx-box2d " + Version.VERSION;
    }

    @Override
    public List<Setting> settings() {
        return PeerSettings.all();
    }

    /** Loads the native libraries if they are not loaded; a list of engines does not need them. */
    @Override
    public World world(Effects effects, Setting setting) {
        GdxNativesLoader.load();
        Box2D.init();
        return new GdxBox2dWorld(effects, setting);
    }
}

package rigibo.frontend.display;

import rigibo.frontend.scene.Deed;
import rigibo.frontend.scene.Skin;
import rigibo.frontend.scene.Sounds;

/** The sounds of the page: none yet. */
final class Silence implements Sounds {

    static final Sounds SOUNDS = new Silence();

    private Silence() {}

    @Override
    public void knock(Skin skin, double size, double impulse) {}

    @Override
    public void roll(double speed) {}

    @Override
    public void pop() {}

    @Override
    public void did(Deed deed) {}

    @Override
    public void refuse() {}

    @Override
    public void tick(double held) {}

    @Override
    public void chord() {}

    @Override
    public void fail() {}

    @Override
    public void press() {}

    @Override
    public boolean isHeard() {
        return false;
    }
}

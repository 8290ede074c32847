package rigibo.frontend.draw;

import rigibo.backend.geometry.Chain;
import rigibo.backend.geometry.Compound;
import rigibo.backend.geometry.Convex;
import rigibo.backend.geometry.Part;
import rigibo.backend.geometry.Shape;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Canvas.Mood;
import rigibo.frontend.scene.ChainBand;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.Skin;

import java.util.List;
import java.util.Map;
import java.util.WeakHashMap;

/**
 * Everything of the world that a frame shows: shadows, bodies, faces and particles, in a few draw
 * calls.
 */
final class BodyBatch {

    private static final int TEXELS = 512;

    /**
     * Factor by which a lifted body is larger, its height, px, and the factor on the distance of
     * its shadow.
     */
    private static final double LIFTED = 1.05;

    private static final double LIFT = 2;
    private static final double LIFTED_SHADOW = 2;

    private final Program bodyProgram = new Program("body", "body");
    private final Program shadowProgram = new Program("shadow", "shadow");
    private final Program dotProgram = new Program("plate", "plate");
    private final ShadowBatch shadows = new ShadowBatch();
    private final SkinBatch bodies = new SkinBatch();
    private final ShadowBatch liftedShadows = new ShadowBatch();
    private final SkinBatch lifted = new SkinBatch();
    private final FaceBatch faces = new FaceBatch();
    private final DotBatch dots = new DotBatch();
    private final ParticleBatch particles = new ParticleBatch();
    private final Map<Chain, List<ChainBand.Piece>> bands = new WeakHashMap<>();
    private final Figure figure = new Figure();
    private final OnScreen at = new OnScreen();
    private final Gaze gaze = new Gaze();
    private Camera camera = Camera.ofPuzzle();
    private Detail detail;
    private Baked skins;
    private double veil;

    /** Begins a frame a number of seconds after the window opened. */
    void begin(double seconds, Detail wanted) {
        gaze.seconds = seconds;
        veil = 0;
        if (wanted != detail) {
            detail = wanted;
            freeSkins();
            skins = new Baked("skin", TEXELS, TEXELS, Skin.values().length, wanted, all -> {});
            skins.shrink();
        }
    }

    void camera(Camera from) {
        camera = from;
    }

    void gaze(double worldX, double worldY) {
        gaze.x = worldX;
        gaze.y = worldY;
    }

    /** Greys out the world by a share from 0, not at all, to 1. */
    void veil(double share) {
        veil = share;
    }

    void body(Shape shape, double x, double y, double angle, Skin skin, Mood mood) {
        if (shape instanceof Compound compound) {
            parts(compound, x, y, angle, skin, mood);
        } else if (shape instanceof Chain chain) {
            band(chain, x, y, angle, skin, mood);
        } else {
            piece((Convex) shape, x, y, angle, skin, mood);
        }
    }

    private void band(Chain chain, double x, double y, double angle, Skin skin, Mood mood) {
        double cos = Math.cos(angle);
        double sin = Math.sin(angle);
        for (ChainBand.Piece piece : bands.computeIfAbsent(chain, ChainBand::of)) {
            piece(
                    piece.polygon(),
                    x + cos * piece.x() - sin * piece.y(),
                    y + sin * piece.x() + cos * piece.y(),
                    angle,
                    skin,
                    mood);
        }
    }

    private void parts(Compound compound, double x, double y, double angle, Skin skin, Mood mood) {
        double cos = Math.cos(angle);
        double sin = Math.sin(angle);
        for (int i = 0; i < compound.parts(); i++) {
            Part part = compound.part(i);
            double dx = part.x() - compound.centroidX();
            double dy = part.y() - compound.centroidY();
            piece(
                    part.shape(),
                    x + cos * dx - sin * dy,
                    y + sin * dx + cos * dy,
                    angle + part.angle(),
                    skin,
                    mood);
        }
    }

    private void piece(Convex shape, double x, double y, double angle, Skin skin, Mood mood) {
        figure.of(shape);
        boolean isLifted = mood == Mood.HOVERED;
        at.place(camera, x, y, angle, isLifted ? LIFTED : 1);
        at.shift(0, isLifted ? -LIFT : 0);
        if (mood != Mood.GHOST) {
            belongings(skin, mood, isLifted);
        }
        (isLifted ? lifted : bodies).add(figure, at, skin, mood);
    }

    /** A body's shadow, face and rivets. */
    private void belongings(Skin skin, Mood mood, boolean isLifted) {
        if (detail == Detail.FULL) {
            (isLifted ? liftedShadows : shadows).add(figure, at, isLifted ? LIFTED_SHADOW : 1);
        }
        if (skin == Skin.RIGIBO) {
            faces.add(figure, at, mood, gaze, dots);
        } else if (skin == Skin.IRON) {
            dots.rivets(figure, at);
        }
    }

    /** A particle of a size in m. */
    void particle(
            ParticleBatch.Kind kind, double x, double y, double size, double angle, Color color) {
        double half = size / 2 * camera.scale();
        particles.add(kind, camera.screenX(x), camera.screenY(y), half, angle, color);
    }

    /** Draws the bodies gathered, and empties the batch. */
    void draw(Layout layout) {
        bodyProgram.use();
        bodyProgram.set("veil", (float) veil);
        shadows.draw(shadowProgram, layout);
        skins.bind();
        bodies.draw(bodyProgram, layout);
        liftedShadows.draw(shadowProgram, layout);
        lifted.draw(bodyProgram, layout);
        faces.draw(layout, veil);
        dots.draw(dotProgram, layout);
        particles.draw(layout);
    }

    void free() {
        shadows.free();
        bodies.free();
        liftedShadows.free();
        lifted.free();
        faces.free();
        dots.free();
        particles.free();
        freeSkins();
        bodyProgram.free();
        shadowProgram.free();
        dotProgram.free();
    }

    private void freeSkins() {
        if (skins != null) {
            skins.free();
        }
    }
}

package rigibo.frontend.puzzle.rules;

import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Fan;
import rigibo.backend.effect.Magnet;

import java.util.ArrayList;
import java.util.List;

/** The fans and magnets among a level's bodies, as effects with their present strengths. */
final class Sources {

    private final List<Piece> pieces;

    Sources(List<Piece> pieces) {
        this.pieces = pieces.stream().filter(it -> it.definition().source().isThere()).toList();
    }

    boolean areAny() {
        return !pieces.isEmpty();
    }

    /** Returns effects with the present streams and magnets, if they declare these. */
    Effects in(Effects declared) {
        List<Fan.Jet> jets = new ArrayList<>();
        List<Magnet.Pole> poles = new ArrayList<>();
        for (Piece piece : pieces) {
            if (piece.isAlive() && piece.isOn()) {
                piece.definition().source().jet().ifPresent(jets::add);
                piece.definition().source().pole().ifPresent(poles::add);
            }
        }
        Effects effects = declared;
        if (declared.declares(Fan.class)) {
            effects = effects.with(new Fan(jets));
        }
        return declared.declares(Magnet.class) ? effects.with(new Magnet(poles)) : effects;
    }
}

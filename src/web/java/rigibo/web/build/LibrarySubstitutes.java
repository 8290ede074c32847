package rigibo.web.build;

import org.teavm.extension.spi.substitution.SimpleSubstitutionPolicy;
import org.teavm.extension.spi.substitution.SubstitutionSink;

/** Names the classes of Java's library that the page replaces. */
public final class LibrarySubstitutes extends SimpleSubstitutionPolicy {

    private static final String OURS = "rigibo.web.library";

    @Override
    public void contribute(SubstitutionSink sink) {
        sink.selectClasses(
                        named("java.util.HexFormat")
                                .or(named("java.util.Random"))
                                .or(named("java.util.SplittableRandom")))
                .replacePackage("java.util", OURS);
        sink.selectClasses(named("java.text.Normalizer").or(named("java.text.Normalizer$Form")))
                .replacePackage("java.text", OURS);
        sink.selectClasses(named("java.util.concurrent.CompletableFuture"))
                .replacePackage("java.util.concurrent", OURS);
        sink.selectClasses(named("java.util.concurrent.atomic.LongAdder"))
                .replacePackage("java.util.concurrent.atomic", OURS);
    }
}

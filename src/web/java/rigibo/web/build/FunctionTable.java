package rigibo.web.build;

import org.teavm.dependency.AbstractDependencyListener;
import org.teavm.jso.impl.JSBodyRepository;
import org.teavm.jso.impl.JSOPlugin;
import org.teavm.jso.impl.wasmgc.FunctionTexts;
import org.teavm.vm.spi.After;
import org.teavm.vm.spi.TeaVMHost;
import org.teavm.vm.spi.TeaVMPlugin;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * Writes the functions by which a program calls the page into a file that the browser reads.
 * Otherwise the program would make them of texts, which a strict policy forbids.
 */
@After(JSOPlugin.class)
public final class FunctionTable implements TeaVMPlugin {

    /** Property that names the file; a program without it makes its functions itself. */
    static final String FILE = "rigibo.functions";

    @Override
    public void install(TeaVMHost host) {
        JSBodyRepository repository = host.getService(JSBodyRepository.class);
        String file = host.getProperties().getProperty(FILE);
        if (file == null) {
            return;
        }
        host.add(
                new AbstractDependencyListener() {
                    @Override
                    public void complete() {
                        write(repository, Path.of(file));
                    }
                });
    }

    private static void write(JSBodyRepository repository, Path file) {
        try {
            Files.writeString(
                    file,
                    "globalThis.rigiboFunctions = " + FunctionTexts.table(repository) + ";\n");
        } catch (IOException full) {
            throw new UncheckedIOException(full);
        }
    }
}

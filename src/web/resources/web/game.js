// Fetches what the game needs and starts it.
const show = problem => {
    const sentence = document.getElementById('problem');
    sentence.textContent = problem;
    sentence.hidden = false;
};

const isGerman = navigator.language.startsWith('de');

// Nothing can be touched before the first picture.
const loading = document.getElementById('loading');
loading.textContent = isGerman ? 'RigiBo lädt …' : 'RigiBo is loading …';

// The smallest module with a type that garbage collection brings.
const collects = new Uint8Array([0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 95, 1, 120, 0]);

const reason = () => {
    // Browsers fetch nothing beside a page that was opened as a file.
    if (location.protocol === 'file:') {
        return isGerman
            ? 'RigiBo spielt, wo ein Webserver es ausliefert: ./rigibo web --serve startet einen.'
            : 'RigiBo plays where a web server serves it: ./rigibo web --serve starts one.';
    }
    if (!window.WebAssembly || !WebAssembly.validate(collects)) {
        return isGerman
            ? 'Diesem Browser fehlt WebAssembly mit Speicherbereinigung, das RigiBo braucht. Neuere haben es.'
            : 'This browser lacks WebAssembly with garbage collection, which RigiBo needs. Newer ones have it.';
    }
    if (!document.createElement('canvas').getContext('webgl2')) {
        return isGerman
            ? 'Diesem Browser fehlt WebGL 2, das RigiBo braucht, oder es ist in seinen Einstellungen abgeschaltet.'
            : 'This browser lacks WebGL 2, which RigiBo needs, or it is switched off in its settings.';
    }
    return isGerman
        ? 'RigiBo konnte nicht geladen werden. Lade die Seite neu.'
        : 'RigiBo could not be loaded. Load the page again.';
};

const start = async () => {
    const [program, files] = await Promise.all([
        TeaVM.wasmGC.load('game.wasm'),
        fetch('files.txt').then(answer => answer.text()),
        document.fonts.load('16px words'),
        document.fonts.load('16px numbers')
    ]);
    window.rigiboFiles = files;
    program.exports.main([]);
    loading.remove();
};

start().catch(problem => {
    loading.remove();
    show(reason());
    console.warn(problem);
});

if ('serviceWorker' in navigator) {
    navigator.serviceWorker.register('offline.js').catch(problem => console.warn(problem));
}

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

Promise.all([
    TeaVM.wasmGC.load('game.wasm'),
    fetch('files.txt').then(answer => answer.text()),
    document.fonts.load('16px words'),
    document.fonts.load('16px numbers')
]).then(([program, files]) => {
    window.rigiboFiles = files;
    program.exports.main([]);
    loading.remove();
}).catch(problem => {
    // Browsers fetch nothing beside a page that was opened as a file.
    loading.remove();
    if (location.protocol === 'file:') {
        show(isGerman
            ? 'RigiBo spielt, wo ein Webserver es ausliefert: ./rigibo web --serve startet einen.'
            : 'RigiBo plays where a web server serves it: ./rigibo web --serve starts one.');
    } else {
        show(isGerman
            ? 'Diesem Browser fehlt WebAssembly mit Speicherbereinigung oder WebGL 2; RigiBo braucht beides.'
            : 'This browser lacks WebAssembly with garbage collection or WebGL 2, which RigiBo needs.');
    }
    console.warn(problem);
});

if ('serviceWorker' in navigator) {
    navigator.serviceWorker.register('offline.js').catch(problem => console.warn(problem));
}

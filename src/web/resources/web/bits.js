// Shows what the program prints, for whoever reads the page.
const lines = document.getElementById('lines');
console.log = (...words) => {
    lines.textContent += words.join(' ') + '\n';
};

Promise.all([TeaVM.wasmGC.load('bits.wasm'), fetch('bits.txt').then(answer => answer.text())])
    .then(([program, files]) => {
        window.rigiboFiles = files;
        program.exports.main([]);
    })
    // To whoever serves the page and cannot look at it.
    .then(() => fetch('said', { method: 'POST', body: lines.textContent }))
    .catch(problem => console.log('This browser cannot run it: ' + problem));

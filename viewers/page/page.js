// Shows the scene that the program wrote into this page: world LPS mm, z superior.
(function () {
'use strict';

const data = JSON.parse(document.getElementById('scene').textContent);
const byId = (id) => document.getElementById(id);
if (data.dark) document.body.classList.add('dark');
byId('title').textContent = data.title;
document.title = data.title.split('\n')[0] || 'isostack';

function unpacked(text, Kind) {
  const raw = atob(text), bytes = new Uint8Array(raw.length);
  for (let i = 0; i < raw.length; ++i) bytes[i] = raw.charCodeAt(i);
  return new Kind(bytes.buffer);
}

let renderer;
try {
  renderer = new THREE.WebGLRenderer({ antialias: true, preserveDrawingBuffer: true });
} catch (error) {
  byId('title').textContent = 'This browser has no WebGL; switch it on, or open the page in another one.';
  document.body.dataset.state = 'no WebGL';
  return;
}
const ground = data.dark ? 0x171a1f : 0xffffff;
renderer.setPixelRatio(window.devicePixelRatio);
renderer.setClearColor(ground);
renderer.autoClear = false;
document.body.appendChild(renderer.domElement);

// --- what is drawn -------------------------------------------------------------------------------

const scene = new THREE.Scene();
const lineMaterials = [];

function surfaceOf(item) {
  const geometry = new THREE.BufferGeometry();
  const places = unpacked(item.vertices.places, Uint16Array), points = new Float32Array(places.length);
  for (let i = 0; i < places.length; ++i) points[i] = item.vertices.from[i % 3] + item.vertices.step * places[i];
  geometry.setAttribute('position', new THREE.BufferAttribute(points, 3));
  geometry.setIndex(new THREE.BufferAttribute(unpacked(item.triangles, Uint32Array), 1));
  if (item.normals) geometry.setAttribute('normal', new THREE.BufferAttribute(unpacked(item.normals, Int8Array), 3, true));
  else geometry.computeVertexNormals();
  if (item.colours) geometry.setAttribute('color', new THREE.BufferAttribute(unpacked(item.colours, Uint8Array), 3, true));
  const material = new THREE.MeshPhongMaterial({
    color: item.colours ? '#ffffff' : item.colour, vertexColors: item.colours ? THREE.VertexColors : THREE.NoColors,
    specular: 0x2a2a2a, shininess: 30, side: THREE.DoubleSide, wireframe: item.wire,
    // Contours lie on the surface: push it back by a hair.
    polygonOffset: true, polygonOffsetFactor: 3, polygonOffsetUnits: 6 });
  const mesh = new THREE.Mesh(geometry, material);
  setOpacity(mesh, item.opacity);
  return mesh;
}

function setOpacity(mesh, opacity) {
  mesh.material.opacity = opacity;
  mesh.material.transparent = opacity < 1;
  mesh.material.depthWrite = opacity >= 1;
  mesh.material.needsUpdate = true;
  mesh.renderOrder = opacity < 1 ? 1 : 0;
}

function linesOf(ends, colour, width) {
  const geometry = new THREE.LineSegmentsGeometry();
  geometry.setPositions(ends);
  const material = new THREE.LineMaterial({ color: new THREE.Color(colour).getHex(), linewidth: width });
  lineMaterials.push(material);
  const lines = new THREE.LineSegments2(geometry, material);
  lines.frustumCulled = false;
  return lines;
}

function sliceOf(item) {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.BufferAttribute(new Float32Array([].concat(...item.corners)), 3));
  geometry.setAttribute('uv', new THREE.BufferAttribute(new Float32Array([0, 1, 1, 1, 1, 0, 0, 0]), 2));
  geometry.setIndex([0, 1, 2, 0, 2, 3]);
  const material = new THREE.MeshBasicMaterial({ side: THREE.DoubleSide, polygonOffset: true, polygonOffsetFactor: 3, polygonOffsetUnits: 6 });
  const mesh = new THREE.Mesh(geometry, material);
  mesh.visible = false;
  // The image is decoded when the slice is first seen.
  mesh.userData.show = (visible) => {
    mesh.visible = visible;
    if (!visible || material.map) return;
    material.map = new THREE.Texture(new Image());
    material.map.minFilter = THREE.LinearFilter;
    material.map.generateMipmaps = false;
    material.map.image.onload = () => { material.map.needsUpdate = true; material.needsUpdate = true; draw(); };
    material.map.image.src = item.png;
  };
  setOpacity(mesh, item.opacity);
  return mesh;
}

function textOf(words, place) {
  const canvas = document.createElement('canvas'), pen = canvas.getContext('2d');
  pen.font = 'bold 40px Arial';
  canvas.width = pen.measureText(words).width + 24;
  canvas.height = 56;
  pen.fillStyle = '#b01368';
  pen.fillRect(0, 0, canvas.width, canvas.height);
  pen.font = 'bold 40px Arial';
  pen.fillStyle = '#fff';
  pen.fillText(words, 12, 42);
  const sprite = new THREE.Sprite(new THREE.SpriteMaterial({ map: new THREE.CanvasTexture(canvas), depthTest: false }));
  sprite.position.fromArray(place);
  sprite.center.set(-0.1, -0.3);
  sprite.scale.set(0.03 * size * canvas.width / canvas.height, 0.03 * size, 1);
  return sprite;
}

function markOf(item) {
  const group = new THREE.Group();
  group.add(linesOf([].concat(item.from, item.to), '#f21a8c', 5));
  if (item.text) group.add(textOf(item.text, item.from.map((from, axis) => (from + item.to[axis]) / 2)));
  return group;
}

const low = new THREE.Vector3().fromArray(data.box[0]), high = new THREE.Vector3().fromArray(data.box[1]);
const centre = low.clone().add(high).multiplyScalar(0.5), size = Math.max(high.distanceTo(low), 1e-3);

// --- layers --------------------------------------------------------------------------------------

function addLayer(kind, index, name, colour, object, visible) {
  const label = document.createElement('label'), box = document.createElement('input');
  box.type = 'checkbox';
  box.id = kind + '-' + index;
  box.checked = visible;
  label.appendChild(box);
  if (colour) {
    const patch = document.createElement('i');
    patch.style.background = colour;
    label.appendChild(patch);
  }
  label.appendChild(document.createTextNode(name));
  label.title = name;
  byId('layers').appendChild(label);
  object.visible = visible;
  scene.add(object);
  box.addEventListener('change', () => { object.visible = box.checked; update(); });
  return box;
}

function addSlider(id, values, change) {
  const slider = document.createElement('input');
  slider.type = 'range';
  slider.id = id;
  [slider.min, slider.max, slider.step, slider.value] = values;
  slider.addEventListener('input', () => { change(Number(slider.value)); update(); });
  byId('layers').appendChild(slider);
  return slider;
}

const surfaces = data.surfaces.map((item, i) => {
  const mesh = surfaceOf(item);
  addLayer('surface', i, item.name, item.bar ? null : item.colour, mesh, item.visible);
  return mesh;
});
if (surfaces.length) {
  const slider = addSlider('opacity', [0.1, 1, 0.05, data.surfaces[0].opacity],
                           (value) => surfaces.forEach((mesh) => setOpacity(mesh, value)));
  slider.title = 'opacity of surfaces';
}
data.contours.forEach((item, i) =>
  addLayer('contours', i, item.name, item.colour, linesOf(unpacked(item.ends, Float32Array), item.colour, 2.5), item.visible));
if (data.slices.length) {
  const images = new THREE.Group(), meshes = data.slices.map(sliceOf);
  meshes.forEach((mesh) => images.add(mesh));
  const chosen = data.slices.map((item) => item.visible);
  const show = (which) => meshes.forEach((mesh, i) => mesh.userData.show(which(i)));
  addLayer('images', 0, 'images', null, images, chosen.some((is) => is));
  show((i) => chosen[i]);
  if (!chosen.some((is) => is)) show((i) => i === meshes.length >> 1);
  if (meshes.length > 1)
    addSlider('image', [0, meshes.length - 1, 1, Math.max(0, chosen.indexOf(true))], (value) => show((i) => i === value)).title = 'image';
}
data.marks.forEach((item, i) => addLayer('mark', i, item.text || 'mark', '#f21a8c', markOf(item), item.visible));

function showBars() {
  byId('bars').textContent = '';
  const shown = [];
  data.surfaces.forEach((item, i) => {
    const key = JSON.stringify(item.bar);
    if (!item.bar || !surfaces[i].visible || shown.includes(key)) return;
    shown.push(key);
    const bar = document.createElement('div'), label = document.createElement('p'), scale = document.createElement('div');
    bar.className = 'bar';
    label.textContent = item.bar.label;
    scale.style.background = 'linear-gradient(to top, ' + item.bar.colours.join(', ') + ')';
    for (let k = 0; k <= 4; ++k) {
      const tick = document.createElement('span');
      tick.style.bottom = 25 * k + '%';
      tick.textContent = Number((item.bar.low + (item.bar.high - item.bar.low) * k / 4).toPrecision(3));
      scale.appendChild(tick);
    }
    bar.appendChild(label);
    bar.appendChild(scale);
    byId('bars').appendChild(bar);
  });
}

// --- camera and light ----------------------------------------------------------------------------

const camera = new THREE.OrthographicCamera(-1, 1, 1, -1, 0.1, 10);
camera.up.set(0, 0, 1);
scene.add(camera);
scene.add(new THREE.HemisphereLight(0xffffff, 0x8890a0, 0.55));
const lamp = new THREE.DirectionalLight(0xffffff, 0.6);
lamp.position.set(-0.5, 0.8, 1);
camera.add(lamp);
camera.add(lamp.target);
lamp.target.position.set(0, 0, -1);
const controls = new THREE.OrbitControls(camera, renderer.domElement);
controls.screenSpacePanning = true;

function look(from) {
  const direction = new THREE.Vector3().fromArray(from).normalize();
  // Straight from above or below the turn about the axis is open: anterior is up then.
  if (Math.abs(direction.z) > 0.999) direction.y = 1e-3 * Math.sign(direction.z);
  controls.target.copy(centre);
  camera.position.copy(centre).addScaledVector(direction.normalize(), 2 * size);
  camera.near = 0.05 * size;
  camera.far = 5 * size;
  camera.zoom = 1;
  camera.updateProjectionMatrix();
  controls.update();
  draw();
}

// A cube with the patient's directions, turning with the camera.
function letterFace(letter) {
  const canvas = document.createElement('canvas'), pen = canvas.getContext('2d');
  canvas.width = canvas.height = 64;
  pen.fillStyle = data.dark ? '#595959' : '#f2f2f2';
  pen.fillRect(0, 0, 64, 64);
  pen.strokeStyle = '#999';
  pen.strokeRect(1, 1, 62, 62);
  pen.fillStyle = data.dark ? '#eee' : '#333';
  pen.font = '46px Arial';
  pen.textAlign = 'center';
  pen.fillText(letter, 32, 48);
  return new THREE.MeshBasicMaterial({ map: new THREE.CanvasTexture(canvas) });
}
const corner = new THREE.Scene(), cornerCamera = new THREE.OrthographicCamera(-1, 1, 1, -1, 0.1, 10);
// Of each face: its letter, the way it looks, and what is up on it.
[['L', [1, 0, 0], [0, 0, 1]], ['R', [-1, 0, 0], [0, 0, 1]], ['P', [0, 1, 0], [0, 0, 1]],
 ['A', [0, -1, 0], [0, 0, 1]], ['S', [0, 0, 1], [0, -1, 0]], ['I', [0, 0, -1], [0, -1, 0]]].forEach(([letter, out, up]) => {
  const face = new THREE.Mesh(new THREE.PlaneGeometry(1, 1), letterFace(letter));
  const outwards = new THREE.Vector3().fromArray(out), upwards = new THREE.Vector3().fromArray(up);
  face.quaternion.setFromRotationMatrix(
    new THREE.Matrix4().makeBasis(upwards.clone().cross(outwards), upwards, outwards));
  face.position.copy(outwards).multiplyScalar(0.5);
  corner.add(face);
});

// --- drawing -------------------------------------------------------------------------------------

function updateScale() {
  const mmPerPixel = (camera.top - camera.bottom) / camera.zoom / window.innerHeight;
  const most = 0.2 * window.innerWidth * mmPerPixel, power = Math.pow(10, Math.floor(Math.log10(most)));
  const length = [5, 2, 1].find((step) => step * power <= most) * power;
  byId('scale').style.width = length / mmPerPixel + 'px';
  byId('scale').firstChild.textContent = Number(length.toPrecision(3)) + ' mm';
}

function draw() {
  const width = window.innerWidth, height = window.innerHeight;
  renderer.setViewport(0, 0, width, height);
  renderer.clear();
  renderer.render(scene, camera);
  cornerCamera.position.copy(camera.position).sub(controls.target).normalize().multiplyScalar(4);
  cornerCamera.up.copy(camera.up);
  cornerCamera.lookAt(0, 0, 0);
  renderer.clearDepth();
  renderer.setViewport(8, 8, 110, 110);
  renderer.render(corner, cornerCamera);
  updateScale();
}

function update() {
  showBars();
  draw();
}

function fit() {
  const width = window.innerWidth, height = window.innerHeight, half = 0.56 * size;
  const aspect = width / height, tall = aspect >= 1 ? half : half / aspect;
  [camera.left, camera.right, camera.top, camera.bottom] = [-tall * aspect, tall * aspect, tall, -tall];
  camera.updateProjectionMatrix();
  renderer.setSize(width, height);
  lineMaterials.forEach((material) => material.resolution.set(width, height));
  draw();
}

[['A', [0, -1, 0]], ['P', [0, 1, 0]], ['L', [1, 0, 0]], ['R', [-1, 0, 0]], ['S', [0, 0, 1]], ['I', [0, 0, -1]]]
  .forEach(([letter, from]) => {
    const button = document.createElement('button');
    button.textContent = letter;
    button.id = 'view-' + letter;
    button.addEventListener('click', () => look(from));
    byId('views').appendChild(button);
  });

cornerCamera.left = cornerCamera.bottom = -0.95;
cornerCamera.right = cornerCamera.top = 0.95;
cornerCamera.updateProjectionMatrix();
controls.addEventListener('change', draw);
window.addEventListener('resize', fit);
fit();
look(data.view_from);
update();
document.body.dataset.state = 'ready';
})();

using System.Collections;
using Alate.Showcase;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play
{
    public sealed class OrbitCameraTests : PlayFixture
    {
        [UnityTest]
        public IEnumerator ThePoint_IsInTheMiddleOfThePicture_AtItsDistance(
            [Values(-170f, 0f, 145f)] float yaw, [Values(-60f, 25f)] float pitch)
        {
            var target = new Vector3(1f, 2f, -3f);
            OrbitCamera orbit = Made(target, 4f);
            orbit.Yaw = yaw;
            orbit.Pitch = pitch;
            yield return Frames(2);

            Vector3 seen = orbit.GetComponent<Camera>().WorldToViewportPoint(target);
            Assert.That(seen.x, Is.EqualTo(0.5f).Within(1e-4f));
            Assert.That(seen.y, Is.EqualTo(0.5f).Within(1e-4f));
            Assert.That(seen.z, Is.EqualTo(4f).Within(1e-4f));
            Assert.That(orbit.transform.up.y, Is.GreaterThan(0f), "the picture stands on its head");
            Assert.That(orbit.transform.right.y, Is.Zero.Within(1e-5f), "the horizon is level");
            Assert.That(
                Mathf.Sign(orbit.transform.position.y - target.y), Is.EqualTo(Mathf.Sign(pitch)), "a camera that looks down is above");
        }

        [UnityTest]
        public IEnumerator WithoutAMainCamera_ItIsTheMainCamera_ElseItDrawsOverIt()
        {
            OrbitCamera first = Made(Vector3.zero, 1f), second = Made(Vector3.zero, 1f);
            yield return null;
            Assert.That(Camera.main, Is.SameAs(first.GetComponent<Camera>()));
            Assert.That(second.GetComponent<Camera>().depth, Is.GreaterThan(Camera.main.depth));
        }

        [Test]
        public void WhereASceneHasASun_NoSecondLightIsMade()
        {
            Light lamp = Keep(new GameObject("lamp")).AddComponent<Light>();
            lamp.type = LightType.Point;
            Assert.That(Made(Vector3.zero, 1f).GetComponentsInChildren<Light>(), Has.Length.EqualTo(1), "a lamp is no sun");

            Light sun = Keep(new GameObject("sun")).AddComponent<Light>();
            sun.type = LightType.Directional;
            Assert.That(Made(Vector3.zero, 1f).GetComponentsInChildren<Light>(), Is.Empty);
        }

        [Test]
        public void PitchAndDistance_StayInTheirRanges()
        {
            OrbitCamera orbit = Made(Vector3.zero, 0f);
            orbit.Pitch = 100f;
            Assert.That(orbit.Pitch, Is.EqualTo(89f));
            Assert.That(orbit.Distance, Is.GreaterThan(0f));
        }

        private OrbitCamera Made(Vector3 target, float distance) =>
            OrbitCamera.Create(Keep(new GameObject("stage")).transform, target, distance);
    }
}

using System.Collections;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.SceneManagement;
using UnityEngine.TestTools;

namespace Alate.Tests.Play
{
    /// <summary>Scenes come and go with their insects.</summary>
    public sealed class SceneTests : FlockFixture
    {
        [UnityTest]
        public IEnumerator AnUnloadedScene_TakesItsInsectsWithIt_AndNoOthers()
        {
            InsectWings staying = Hatch(), going = Hatch();
            Scene scene = SceneManager.CreateScene("additive");
            SceneManager.MoveGameObjectToScene(going.gameObject, scene);
            yield return Frames(5);
            Assert.That(going.State, Is.EqualTo(InsectState.Ready));

            yield return SceneManager.UnloadSceneAsync(scene);
            yield return Frames(3);

            Assert.That(going == null, Is.True);
            Assert.That(staying.State, Is.EqualTo(InsectState.Ready));
            Assert.That(WingSystem.InsectCount, Is.EqualTo(1));
        }

        [UnityTest]
        public IEnumerator TheSystem_OutlivesTheSceneInWhichItBegan()
        {
            Scene before = SceneManager.GetActiveScene(), scene = SceneManager.CreateScene("first");
            SceneManager.SetActiveScene(scene);
            InsectWings going = Hatch();
            yield return Frames(3);
            SceneManager.SetActiveScene(before);
            InsectWings staying = Hatch();
            yield return Frames(3);

            yield return SceneManager.UnloadSceneAsync(scene);
            yield return Frames(3);

            Assert.That(going == null, Is.True);
            Assert.That(staying.State, Is.EqualTo(InsectState.Ready));
            float beats = Beats(staying);
            yield return Frames(10);
            Assert.That(Beats(staying), Is.GreaterThan(beats + 0.5f));
        }

        [UnityTest]
        public IEnumerator AnInsectThatOutlivesItsScene_BeatsOn()
        {
            Scene scene = SceneManager.CreateScene("left");
            InsectWings insect = Hatch();
            SceneManager.MoveGameObjectToScene(insect.gameObject, scene);
            yield return Frames(3);
            Object.DontDestroyOnLoad(insect.gameObject);
            float beats = Beats(insect);

            yield return SceneManager.UnloadSceneAsync(scene);
            yield return Frames(10);

            Assert.That(insect.State, Is.EqualTo(InsectState.Ready));
            Assert.That(Beats(insect), Is.GreaterThan(beats + 0.5f));
        }

        [UnityTest]
        public IEnumerator TheWindOfAnUnloadedScene_Ceases()
        {
            InsectWings insect = Hatch();
            Scene scene = SceneManager.CreateScene("windy");
            WindZone zone = Keep(new GameObject("wind")).AddComponent<WindZone>();
            zone.windMain = 10f;
            zone.windTurbulence = zone.windPulseMagnitude = 0f;
            SceneManager.MoveGameObjectToScene(zone.gameObject, scene);
            WingSystem.FindWindZones();
            yield return Frames(3);
            Assert.That(insect.Live.flight.wind.z, Is.EqualTo(10f).Within(1e-3f));

            yield return SceneManager.UnloadSceneAsync(scene);
            yield return Frames(3);
            Assert.That(insect.Live.flight.wind.z, Is.Zero);
        }
    }
}

using System.Collections;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.SceneManagement;
using UnityEngine.TestTools;

namespace Alate.Tests.Play.Headless
{
    /// <summary>Wind zones that come with a scene while insects live, and with nothing else that changes.</summary>
    public sealed class LoadedSceneTests : PlayFixture
    {
        [UnityTest]
        public IEnumerator TheWindOfALoadedScene_IsFelt([Values] bool isLoaded)
        {
            InsectWings insect = Insect();
            yield return Frames(5);
            Scene scene = isLoaded ? SceneManager.Load("windy", LoadSceneMode.Additive, Blow) : SceneManager.CreateScene("still");
            if (!isLoaded)
                Blow();
            yield return Frames(4);
            Assert.That(insect.Live.flight.wind.z, Is.EqualTo(isLoaded ? 6f : 0f).Within(1e-3f), "one that a script makes is searched for");
            yield return SceneManager.UnloadSceneAsync(scene);
        }

        private void Blow()
        {
            WindZone zone = Keep(new GameObject("wind")).AddComponent<WindZone>();
            zone.windMain = 6f;
            zone.windTurbulence = zone.windPulseMagnitude = 0f;
        }
    }
}

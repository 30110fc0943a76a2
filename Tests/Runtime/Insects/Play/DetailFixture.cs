using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Tests.Play
{
    /// <summary>Play-mode tests of small insects that a camera looks at from near and far.</summary>
    public abstract class DetailFixture : FlockFixture
    {
        /// <summary>The camera by which levels of detail are chosen.</summary>
        protected Camera Camera { get; private set; }

        [SetUp]
        public void MakeACamera()
        {
            Camera = Keep(new GameObject("camera")).AddComponent<Camera>();
            Camera.fieldOfView = 60f;
            Camera.farClipPlane = 1e5f;
            WingSystem.DetailCameras.Add(Camera);
        }

        /// <summary>Moves the camera so far away that the insect's wing fills a share of the screen's height.</summary>
        protected void Look(InsectWings insect, float height)
        {
            float distance = QualitySettings.lodBias / (height * math.tan(math.radians(30f)));
            Camera.transform.position = insect.transform.position - distance * Vector3.forward;
        }
    }
}

using System.Collections;
using Alate.Catalogue;
using Alate.Flight;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.SceneManagement;
using UnityEngine.TestTools;

namespace Alate.Tests.Play
{
    /// <summary>Insects that fly, while time, scale, parents and scenes change.</summary>
    public sealed class FlightSceneTests : FlightFixture
    {
        [UnityTest]
        public IEnumerator TheWay_GrowsWithTheGamesTime(
            [Values(0.1f, 1f, 4f)] float scale,
            [Values(WingUpdateMode.FixedUpdate, WingUpdateMode.Update, WingUpdateMode.UnscaledTime)] WingUpdateMode mode)
        {
            InsectFlight flight = Hatch();
            flight.GetComponent<InsectWings>().UpdateMode = mode;
            flight.Velocity = new Vector3(0f, 0f, 0.6f);
            yield return Frames(120);
            Time.timeScale = scale;
            Vector3 before = flight.Position;
            yield return Frames(60);
            float seconds = 60f * Time.captureDeltaTime * (mode == WingUpdateMode.UnscaledTime ? 1f : scale);
            Assert.That(
                (flight.Position - before).z / InsectDefinition.UnitsPerMetre, Is.EqualTo(0.6f * seconds).Within(0.1f + 0.1f * seconds));
            Assert.That(flight.State, Is.EqualTo(FlightState.Flying));
        }

        [UnityTest]
        public IEnumerator SteppedByHand_ItFlies()
        {
            InsectFlight flight = Hatch();
            InsectWings wings = flight.GetComponent<InsectWings>();
            wings.UpdateMode = WingUpdateMode.Manual;
            flight.Velocity = new Vector3(0f, 0f, 0.6f);
            yield return Frames(3);
            for (int frame = 0; frame < 180; frame++)
            {
                wings.Step(0.02f);
                yield return null;
            }

            Assert.That(flight.State, Is.EqualTo(FlightState.Flying));
            Assert.That(flight.BodyVelocity.z, Is.EqualTo(0.6f).Within(0.3f));
        }

        [UnityTest]
        public IEnumerator AnotherScaleInFlight_IsTakenOver_WhereItIs([Values(0.2f, 3f)] float scale)
        {
            InsectFlight flight = Hatch();
            flight.Velocity = new Vector3(0f, 0f, 0.6f);
            yield return Frames(120);
            Vector3 place = flight.transform.position;
            flight.transform.localScale = scale * Vector3.one;
            yield return Frames(3);
            Assert.That((flight.transform.position - place).magnitude, Is.LessThan(1.5f * Mathf.Max(scale, 1f)));
            Vector3 before = flight.Position;
            yield return Frames(60);
            Assert.That((flight.Position - before).z / (InsectDefinition.UnitsPerMetre * scale), Is.EqualTo(0.6f).Within(0.15f));
        }

        [UnityTest]
        public IEnumerator WithoutASize_ItStaysWhereItIs_AndFliesOnWithOne()
        {
            InsectFlight flight = Hatch();
            flight.Velocity = new Vector3(0f, 0f, 0.6f);
            yield return Frames(60);
            flight.transform.localScale = Vector3.zero;
            yield return Frames(60);
            Vector3 place = flight.transform.position;
            yield return Frames(60);
            Assert.That((flight.transform.position - place).magnitude, Is.LessThan(0.01f));
            flight.transform.localScale = Vector3.one;
            yield return Frames(30);
            Assert.That((flight.transform.position - place).magnitude, Is.LessThan(6f));
            Assert.That(flight.State, Is.EqualTo(FlightState.Flying));
        }

        [UnityTest]
        public IEnumerator BelowAParentThatMoves_ItGoesAlong()
        {
            Transform parent = Keep(new GameObject("carriage")).transform;
            InsectFlight flight = Hatch();
            flight.transform.SetParent(parent, true);
            yield return Frames(60);
            Vector3 place = flight.transform.localPosition;
            for (int frame = 0; frame < 120; frame++)
            {
                parent.position += 0.1f * Vector3.right;
                yield return null;
            }

            Assert.That((flight.transform.localPosition - place).magnitude, Is.LessThan(2f));
            Assert.That(flight.State, Is.EqualTo(FlightState.Flying));
        }

        [UnityTest]
        public IEnumerator AnUnloadedScene_TakesItsInsectsWithIt_TheOthersFlyOn()
        {
            InsectFlight staying = Hatch(), going = Hatch();
            Scene scene = SceneManager.CreateScene("flights");
            SceneManager.MoveGameObjectToScene(going.gameObject, scene);
            yield return Frames(60);
            yield return SceneManager.UnloadSceneAsync(scene);
            yield return Frames(60);
            Assert.That(going == null, Is.True);
            Assert.That(staying.State, Is.EqualTo(FlightState.Flying));
        }
    }
}

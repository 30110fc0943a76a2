using System.Collections;
using Alate.Catalogue;
using Alate.Flight;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play
{
    /// <summary>Insects that fly with a Rigidbody.</summary>
    public sealed class FlightRigidbodyTests : FlightFixture
    {
        [UnityTest]
        public IEnumerator WithARigidbody_AMonarchFliesTheSamePath([Values] bool kinematic)
        {
            Time.captureDeltaTime = Time.fixedDeltaTime;
            InsectFlight flight = Hatch(), twin = Hatch();
            AddBody(flight).isKinematic = kinematic;
            twin.Velocity = flight.Velocity = new Vector3(0f, 0f, 0.6f);
            twin.GetComponent<InsectWings>().UpdateMode = WingUpdateMode.FixedUpdate;
            for (int frame = 0; frame < 150; frame++)
            {
                yield return null;
                Assert.That((flight.Position - twin.Position).magnitude, Is.LessThan(0.05f), $"frame {frame}");
            }

            Assert.That(flight.State, Is.EqualTo(FlightState.Flying));
            Assert.That(flight.Position.z, Is.GreaterThan(8f));
            Assert.That((flight.transform.position - twin.transform.position).magnitude, Is.LessThan(0.5f));
        }

        [UnityTest]
        public IEnumerator ItsGravityIsOff_WhileTheWingsCarryIt()
        {
            InsectFlight flight = Hatch();
            Rigidbody body = AddBody(flight);
            yield return Frames(30);
            Assert.That(body.useGravity, Is.False);
            flight.enabled = false;
            Assert.That((body.useGravity, body.maxAngularVelocity), Is.EqualTo((true, 7f)));
        }

        [UnityTest]
        public IEnumerator DampingOfTheRigidbody_IsNoPush_AndComesBackWithIt([Values(0f, 0.05f, 5f)] float damping)
        {
            Time.captureDeltaTime = Time.fixedDeltaTime;
            InsectFlight flight = Hatch(), twin = Hatch();
            Rigidbody body = AddBody(flight), undamped = AddBody(twin);
            (body.drag, body.angularDrag) = (damping, damping);
            (undamped.drag, undamped.angularDrag) = (0f, 0f);
            twin.Velocity = flight.Velocity = new Vector3(0f, 0f, 0.6f);
            for (int frame = 0; frame < 60; frame++)
            {
                yield return null;
                // The physics damp the one step before the wings carry the body.
                Assert.That((flight.Position - twin.Position).magnitude, Is.LessThan(0.02f), $"frame {frame}");
            }

            flight.enabled = false;
            Assert.That((body.drag, body.angularDrag), Is.EqualTo((damping, damping)));
        }

        [UnityTest]
        public IEnumerator FrozenAxes_AreNoPush_AndContactsAlongTheOthersAre()
        {
            Time.captureDeltaTime = Time.fixedDeltaTime;
            Rigidbody body = Keep(new GameObject("body")).AddComponent<Rigidbody>();
            var carried = new CarriedRigidbody(body);
            foreach (RigidbodyConstraints frozen in new[]
            {
                RigidbodyConstraints.None, RigidbodyConstraints.FreezePositionX, RigidbodyConstraints.FreezePosition,
                RigidbodyConstraints.FreezeRotationY, RigidbodyConstraints.FreezeAll,
            })
            {
                body.constraints = frozen;
                carried.Move(body.position + new Vector3(0.02f, 0.03f, -0.01f), Quaternion.Euler(1f, 2f, 3f) * body.rotation, 0.02f);
                yield return Frames(1);
                Assert.That((carried.Pushed.magnitude, carried.Spun.magnitude), Is.EqualTo((0f, 0f)).Using<(float, float)>(
                    (one, other) => Mathf.Abs(one.Item1 - other.Item1) + Mathf.Abs(one.Item2 - other.Item2) < 1e-3f ? 0 : 1), $"{frozen}");

                body.AddForce(new Vector3(0f, 0f, 0.5f), ForceMode.VelocityChange);
                Assert.That(carried.Pushed.z, Is.EqualTo((frozen & RigidbodyConstraints.FreezePositionZ) == 0 ? 0.5f : 0f).Within(1e-3f));
            }
        }

        [UnityTest]
        public IEnumerator APush_GoesIntoTheFlight_AndTheWingsTakeItOut()
        {
            InsectFlight flight = Hatch();
            Rigidbody body = AddBody(flight);
            yield return Frames(120);
            float before = flight.BodyVelocity.x;
            body.AddForce(0.5f * InsectDefinition.UnitsPerMetre * Vector3.right, ForceMode.VelocityChange);
            yield return Frames(3);
            Assert.That(flight.BodyVelocity.x - before, Is.EqualTo(0.5f).Within(0.2f));
            float place = flight.Position.x, farthest = place;
            for (int frame = 0; frame < 180; frame++)
            {
                yield return null;
                farthest = Mathf.Max(farthest, flight.Position.x);
            }

            Assert.That(flight.State, Is.EqualTo(FlightState.Flying));
            Assert.That(flight.BodyVelocity.x, Is.EqualTo(0f).Within(0.2f));
            Assert.That(farthest - place, Is.GreaterThan(0.3f));
        }

        [UnityTest]
        public IEnumerator PlacedElsewhere_ItFliesOnFromThere([Values] bool kinematic)
        {
            InsectFlight flight = Hatch();
            Rigidbody body = AddBody(flight);
            body.isKinematic = kinematic;
            yield return Frames(60);
            var place = new Vector3(40f, 5f, -20f);
            body.position = place;
            body.rotation = Quaternion.Euler(0f, 120f, 0f) * body.rotation;
            float heading = body.rotation.eulerAngles.y;
            yield return Frames(30);
            Assert.That((flight.transform.position - place).magnitude, Is.LessThan(2f));
            Assert.That(flight.State, Is.EqualTo(FlightState.Flying));
            Assert.That(Mathf.DeltaAngle(body.rotation.eulerAngles.y, heading), Is.EqualTo(0f).Within(25f));
        }

        [UnityTest]
        public IEnumerator APerchedOne_SitsStill_AndTakesOff([Values] bool kinematic)
        {
            InsectFlight flight = Hatch();
            Rigidbody body = AddBody(flight);
            body.isKinematic = kinematic;
            yield return Frames(30);
            var pilot = new Sitter();
            flight.Pilot = pilot;
            yield return Frames(60);
            Vector3 place = body.position;
            yield return Frames(30);
            Assert.That(flight.State, Is.EqualTo(FlightState.Perched));
            Assert.That((body.position - place).magnitude, Is.LessThan(1e-3f));
            pilot.flies = true;
            yield return Frames(60);
            Assert.That(flight.State, Is.EqualTo(FlightState.Flying));
            Assert.That((flight.transform.position - place).magnitude, Is.LessThan(5f));
        }

        [UnityTest]
        public IEnumerator ARigidbodyThatIsDestroyed_LeavesTheTransformToTheFlight()
        {
            InsectFlight flight = Hatch();
            Rigidbody body = AddBody(flight);
            flight.Velocity = new Vector3(0f, 0f, 0.6f);
            yield return Frames(60);
            Object.Destroy(body);
            Vector3 place = flight.transform.position;
            yield return Frames(60);
            Assert.That(flight.State, Is.EqualTo(FlightState.Flying));
            Assert.That(flight.transform.position.z - place.z, Is.EqualTo(6f).Within(2f));
        }

        private static Rigidbody AddBody(InsectFlight flight) => flight.gameObject.AddComponent<Rigidbody>();

        private sealed class Sitter : IFlightPilot
        {
            public bool flies;

            public FlightCommand Command(in FlightSituation situation) => new FlightCommand
            {
                wish = flies ? FlightWish.Fly : FlightWish.Perch,
                spot = new PerchSpot { normal = Vector3.up },
            };
        }
    }
}

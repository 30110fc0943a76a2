using System.Linq;
using Alate.Catalogue;
using Alate.Flight;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Alate.Tests.Flight
{
    /// <summary>Insects of a scene and of the catalogue as bodies that fly.</summary>
    public sealed class FlightModelTests
    {
        [TestCase("monarch")]
        [TestCase("swallowtail")]
        public void AnInsectInAScene_HasItsWingsAndItsMassWhereTheCatalogueHasThem(string name)
        {
            InsectDefinition species = InsectCatalogue.Find(name);
            using FlightModel model = CatalogueFlight.CreateModel(species);
            InsectWings wings = Place(species);
            using FlightModel scene = wings.GetComponent<InsectFlight>().CreateModel();
            Object.DestroyImmediate(wings.gameObject);
            Assert.That(scene.Wings, Has.Count.EqualTo(model.Wings.Count));
            foreach (FlightWing wing in model.Wings)
            {
                Assert.That(
                    scene.Wings.Min(other => math.distance(other.Hinge, wing.Hinge)), Is.LessThan(1e-5f * model.Length), $"{wing.Hinge}");
            }
            Assert.That(math.distance(scene.Centre, model.Centre), Is.LessThan(1e-5f * model.Length));
            for (int axis = 0; axis < 3; axis++)
            {
                Assert.That(math.distance(scene.Inertia[axis], model.Inertia[axis]), Is.LessThan(1e-4f * model.Inertia[axis][axis]),
                    $"axis {axis}");
            }
        }

        [Test]
        public void WingsThatSitElsewhere_MoveTheCentreByTheirShareOfTheMass()
        {
            InsectDefinition monarch = InsectCatalogue.Find("monarch");
            using FlightModel model = CatalogueFlight.CreateModel(monarch);
            InsectWings wings = Place(monarch);
            foreach (Wing wing in wings.Wings)
                wing.Renderer.transform.localPosition += new Vector3(0f, 0.05f, 0.1f);
            using FlightModel moved = wings.GetComponent<InsectFlight>().CreateModel();
            Object.DestroyImmediate(wings.gameObject);
            float3 way = moved.Wings[0].Hinge - model.Wings[0].Hinge,
                expected = model.Centre + way * (model.Wings.Sum(wing => wing.Mass) / model.Mass);
            Assert.That(math.length(way), Is.EqualTo(0.011f).Within(0.001f));
            Assert.That(math.distance(moved.Centre, expected), Is.LessThan(1e-7f));
        }

        private static InsectWings Place(InsectDefinition species)
        {
            InsectWings wings = InsectFactory.Create(species, InsectVariant.Flight);
            wings.transform.SetPositionAndRotation(new Vector3(30f, -4f, 7f), Quaternion.Euler(20f, 130f, 50f));
            CatalogueFlight.AddTo(wings, species);
            return wings;
        }
    }
}

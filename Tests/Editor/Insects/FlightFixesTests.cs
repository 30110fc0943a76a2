using System;
using System.Collections.Generic;
using Alate.Catalogue;
using Alate.Flight;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Alate.Editor.Tests
{
    /// <summary>Messages of the inspector of Insect Flight, and their fixes.</summary>
    public sealed class FlightFixesTests
    {
        private const string k_Home = "Assets/Alate Test Flights", k_Path = k_Home + "/Trims.asset";

        private readonly List<GameObject> m_Made = new List<GameObject>();

        [TearDown]
        public void TakeAllAway()
        {
            foreach (GameObject made in m_Made)
                Object.DestroyImmediate(made);
            m_Made.Clear();
            AssetDatabase.DeleteAsset(k_Path);
            Undo.ClearAll();
        }

        // The tests change what is placed, not the prefab.
        [OneTimeTearDown]
        public void TakePrefabsAway() => AssetDatabase.DeleteAsset(k_Home);

        [Test]
        public void AnInsectOfTheMenu_HasNothingTheMatter()
        {
            InsectFlight flight = Place();
            var status = FlightStatus.Of(flight);
            Assert.That(status.Fault, Is.EqualTo(FlightFault.None), status.Message);
            Assert.That(status.Message, Is.Empty);
        }

        [Test]
        public void EachFault_IsTold()
        {
            InsectFlight flight = Place();
            flight.Trims = null;
            Assert.That(FlightStatus.Of(flight).Fault, Is.EqualTo(FlightFault.NoTrims));
            flight.Parts.Clear();
            Assert.That(FlightStatus.Of(flight).Fault, Is.EqualTo(FlightFault.NoBody));
            flight.GetComponent<InsectWings>().Wings.Clear();
            Assert.That(FlightStatus.Of(flight).Fault, Is.EqualTo(FlightFault.Wings));
        }

        [Test]
        public void APilot_IsAdded_AndUndone()
        {
            InsectFlight flight = Place();
            Object.DestroyImmediate(flight.GetComponent<WanderPilot>());
            Assert.That(FlightStatus.Of(flight).Fault, Is.EqualTo(FlightFault.NoPilot));
            Edits.InOneStep("Add", () => FlightFixes.AddPilot(flight));
            Assert.That(FlightStatus.Of(flight).Fault, Is.EqualTo(FlightFault.None));
            Assert.That(flight.GetComponent<WanderPilot>().FromStart, Is.True);
            Undo.PerformUndo();
            Assert.That(FlightStatus.Of(flight).Fault, Is.EqualTo(FlightFault.NoPilot));
        }

        [Test]
        public void AMonarchsBody_IsThatOfTheCatalogue_ForWingsOfItsSize()
        {
            InsectFlight flight = Place("monarch");
            flight.Parts.Clear();
            FlightFixes.TakeBody(flight);
            IReadOnlyList<BodyEllipsoid> parts = InsectCatalogue.Find("monarch").FlightParts;
            Assert.That(flight.Parts.Count, Is.EqualTo(parts.Count));
            for (int k = 0; k < parts.Count; k++)
                Assert.That((flight.Parts[k].halfAxes - parts[k].halfAxes).magnitude, Is.LessThan(1e-7f));
        }

        [Test]
        public void TheModelOfAnInsect_IsThatOfItsTrims([Values("monarch", "firefly")] string name)
        {
            InsectFlight flight = Place(name);
            using (FlightModel model = flight.CreateModel())
            using (TrimTable table = CatalogueFlight.CreateTable(InsectCatalogue.Find(name), model))
                Assert.That(table, Is.Not.Null);
        }

        [Test]
        public void BakedTrims_AreSavedAndAssigned_AndUndone()
        {
            InsectFlight flight = Place();
            FlightTrims before = flight.Trims;
            FixOutcome outcome = FlightFixes.BakeTrims(flight, Given, (title, name, message) => k_Path);
            Assert.That(outcome.IsDone, Is.True, outcome.Message);
            Assert.That(AssetDatabase.GetAssetPath(flight.Trims), Is.EqualTo(k_Path));
            Undo.PerformUndo();
            Assert.That(flight.Trims, Is.SameAs(before));
        }

        [Test]
        public void WhereNothingCloses_TheMissingIsSaid_AndNothingSaved()
        {
            InsectFlight flight = Place();
            FlightTrims before = flight.Trims;
            FixOutcome outcome = FlightFixes.BakeTrims(flight, Nothing, (title, name, message) => k_Path);
            Assert.That((outcome.IsDone, outcome.Message), Is.EqualTo((false, "No steady flight was found. The lift is missing.")));
            Assert.That(flight.Trims, Is.SameAs(before));
            Assert.That(AssetDatabase.LoadAssetAtPath<FlightTrims>(k_Path) == null, Is.True);
        }

        [Test]
        public void AnImpossibleBody_IsSaidInOneLine()
        {
            InsectFlight flight = Place();
            flight.Parts.Clear();
            FixOutcome outcome = FlightFixes.BakeTrims(flight, Given, (title, name, message) => k_Path);
            Assert.That((outcome.IsDone, outcome.Message), Is.EqualTo((false, "A body needs at least one part with mass.")));
        }

        private static TrimTable Given(FlightModel model, Action<string> tell, out string missing)
        {
            missing = null;
            return CatalogueFlight.CreateTable(InsectCatalogue.Find("firefly"), model);
        }

        private static TrimTable Nothing(FlightModel model, Action<string> tell, out string missing)
        {
            missing = "The lift is missing.";
            return null;
        }

        private InsectFlight Place(string name = "firefly")
        {
            GameObject made = new InsectPlacing(k_Home).Place(name, null, true);
            m_Made.Add(made);
            return made.GetComponent<InsectFlight>();
        }
    }
}

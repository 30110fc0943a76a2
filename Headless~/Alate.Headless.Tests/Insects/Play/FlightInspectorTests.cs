using System.Collections;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text.RegularExpressions;
using Alate.Editor;
using Alate.Flight;
using Alate.Tests.Editor;
using NUnit.Framework;
using StandIns;
using UnityEditor;
using UnityEngine;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;

namespace Alate.Tests.Play.Headless
{
    /// <summary>The inspector and the gizmos of an insect that flies, or should.</summary>
    public sealed class FlightInspectorTests : FlightFixture
    {
        private UnityEditor.Editor m_Editor;

        [TearDown]
        public void CloseInspector()
        {
            Object.DestroyImmediate(m_Editor);
            AnsweredDialogs.Clear();
            Undo.ClearAll();
        }

        [UnityTest]
        public IEnumerator OfAnInsectThatFlies_NumbersAreShown_AndItsArrowsAndItsTrail()
        {
            InsectFlight flight = Hatch();
            flight.Velocity = new Vector3(0f, 0f, 0.6f);
            m_Editor = UnityEditor.Editor.CreateEditor(flight);
            Assert.That(m_Editor.RequiresConstantRepaint(), Is.True, "its numbers change");
            yield return Frames(60);
            ShownGizmos.Of(flight);
            yield return Frames(30);
            typeof(InsectFlight).GetProperty(nameof(InsectFlight.AidPower)).SetValue(flight, 0.01234f);
            var page = DrawnInspector.Of(m_Editor);
            List<(string Shape, Color Colour, Vector3[] Places)> drawn = ShownGizmos.Of(flight);
            Assert.That(flight.TryReadTrim(out WingDrive _, out Vector3 ahead), Is.True);
            Assert.That((drawn[2].Places[1] - flight.Position - ahead).magnitude, Is.LessThan(1e-3f), "a unit for a metre per second");

            // A pilot is missing, which is said first; with one the numbers are told.
            Assert.That(page.Buttons, Is.EqualTo(new[] { "Add Wander Pilot", "Record" }));
            page = DrawnInspector.Press(m_Editor, "Add Wander Pilot");
            Assert.That(flight.GetComponent<WanderPilot>().FromStart, Is.True);
            string line = page.HelpBoxes.Single();
            double[] told = [.. Regex.Matches(line, @"-?\d+(\.\d+)?").Select(m => double.Parse(m.Value, CultureInfo.InvariantCulture))];
            Assert.That(flight.TryReadTrim(out WingDrive drive, out Vector3 wanted), Is.True);
            Assert.That(line, Does.StartWith("Flying, "));
            double[] numbers =
            [
                flight.BodyVelocity.magnitude, 1e3 * flight.AidPower, wanted.magnitude, drive.frequency, drive.amplitude,
                Mathf.Rad2Deg * drive.tilt, Mathf.Rad2Deg * drive.meanSweep,
            ];
            Assert.That(told, Has.Length.EqualTo(numbers.Length));
            for (int k = 0; k < numbers.Length; k++)
                Assert.That(told[k], Is.EqualTo(numbers[k]).Within(k < 3 || k == 4 ? 0.0051 : k == 3 ? 0.051 : 0.51), $"number {k}");

            Assert.That(drawn.Take(3).Select(arrow => arrow.Colour),
                Is.EqualTo(new[] { GizmoColours.Velocity, GizmoColours.Up, GizmoColours.Span }));
            Assert.That(drawn.Take(3).Select(arrow => arrow.Places[0]), Is.All.EqualTo(flight.Position));
            Assert.That((drawn[0].Places[1] - flight.Position - flight.BodyVelocity).magnitude, Is.LessThan(1e-3f));
            Assert.That((drawn[1].Places[1] - flight.Position - flight.Force).magnitude, Is.LessThan(1e-3f));
            Assert.That((drawn[2].Places[1] - flight.Position).normalized.z, Is.GreaterThan(0.9f), "wanted ahead");
            Assert.That(drawn[3].Colour, Is.EqualTo(GizmoColours.Bounds));
            Assert.That(drawn[^1].Places[1], Is.EqualTo(flight.Position), "a trail up to here");
            Assert.That((drawn[^1].Places[0] - flight.Position).magnitude, Is.GreaterThan(0.04f));
        }

        [UnityTest]
        public IEnumerator WhatKeepsItFromFlying_IsMendedByAButton_OfAllThatAreSelected()
        {
            InsectFlight one = Hatch(), two = Hatch();
            one.enabled = two.enabled = false;
            one.gameObject.AddComponent<WanderPilot>();
            one.Parts.Clear();
            two.Parts.Clear();
            m_Editor = UnityEditor.Editor.CreateEditor(new Object[] { one, two });
            Assert.That(m_Editor.RequiresConstantRepaint(), Is.False);
            var page = DrawnInspector.Of(m_Editor);
            Assert.That(page.HelpBoxes.Single(), Does.StartWith("Does not fly: its body has no parts."));
            Assert.That(page.Control(page.HelpBoxes.Single()).Value, Is.EqualTo("Warning"));
            DrawnInspector.Press(m_Editor, "Take A Monarch's Body");
            Assert.That((one.Parts.Count, two.Parts.Count), Is.EqualTo((3, 3)));

            one.Trims = two.Trims = null;
            page = DrawnInspector.Of(m_Editor);
            Assert.That(page.HelpBoxes.Single(), Does.StartWith("Does not fly: it has no trims."));
            AnsweredDialogs.Answers.Enqueue("Packages/a.asset");
            AnsweredDialogs.Answers.Enqueue("Packages/b.asset");
            page = DrawnInspector.Press(m_Editor, "Bake Trims…");
            Assert.That(AnsweredDialogs.Texts, Has.Count.EqualTo(2).And.All.StartsWith("Save Flight Trims: "));
            Assert.That(page.Controls.Select(control => control.Text), Has.Some.Contains("is not in the project's Assets folder"));
            yield return null;
        }
    }
}

using NUnit.Framework;
using UnityEditor;
using UnityEngine;

namespace Alate.Editor.Tests
{
    /// <summary>Lines that a property drawer hands out.</summary>
    public sealed class RowsTests
    {
        [Test]
        public void Lines_FollowOneAnother_AGapApart_AndFillTheHeightAskedFor([Values(1, 2, 5)] int count)
        {
            float line = EditorGUIUtility.singleLineHeight, gap = EditorGUIUtility.standardVerticalSpacing;
            var place = new Rect(3f, 7f, 100f, Rows.HeightOf(count));
            var rows = new Rows(place);
            float next = place.y;
            for (int k = 0; k < count; k++, next += line + gap)
                Assert.That(rows.Next(), Is.EqualTo(new Rect(3f, next, 100f, line)), $"line {k}");
            Assert.That(next - gap, Is.EqualTo(place.yMax).Within(1e-4f));
        }

        [Test]
        public void ALine_OfItsOwnHeight_PushesTheNextDown()
        {
            var rows = new Rows(new Rect(0f, 0f, 50f, 90f));
            Assert.That(rows.Next(31f), Is.EqualTo(new Rect(0f, 0f, 50f, 31f)));
            Assert.That(rows.Next().y, Is.EqualTo(31f + EditorGUIUtility.standardVerticalSpacing));
            Assert.That(Rows.HeightOf(0), Is.Zero);
        }
    }
}

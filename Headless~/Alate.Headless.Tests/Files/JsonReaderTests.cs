using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.Json;
using NUnit.Framework;

namespace Alate.Tests.Files
{
    /// <summary>The package's reader of JSON against that of .NET.</summary>
    public sealed class JsonReaderTests
    {
        private const string k_Sample = "{\n \"a\": [1, -0.5, 2e3, 1.5E-7, 0, []],\r\n "
            + "\"b\\u00e9\": {\"c\": true, \"d\": false, \"e\": null},\n"
            + "\t\"f\": \"x\\\"\\\\\\/\\b\\f\\n\\r\\t\\ud83d\\ude00é😀\", \"\": {} }";

        private const string k_Letters = "{}[]\",:0123456789.eE+-\\/ utrfalsnd\n\t\u0001\ud83d\u00e9";

        [Test]
        public void DamagedTexts_AreTakenAndRefused_AsByTheReaderOfDotNet()
        {
            int taken = 0;
            for (int seed = 0; seed < 6000; seed++)
            {
                string text = Damaged(seed);
                object expected = Expected(text);
                taken += expected == null ? 0 : 1;
                Assert.That(Read(text), Is.EqualTo(expected), text);
            }

            Assert.That(taken, Is.InRange(600, 4000), "some are whole, and many are not");
        }

        [TestCase(32, ExpectedResult = true)]
        [TestCase(33, ExpectedResult = false)]
        public bool Nesting_HasALimit(int depth) => Read(new string('[', depth) + new string(']', depth)) != null;

        [Test]
        public void ManyListsBesideOneAnother_AreNotDeep() =>
            Assert.That(JsonReader.Read("[" + string.Join(",", Enumerable.Repeat("[{}]", 200)) + "]").Items, Has.Count.EqualTo(200));

        [Test]
        public void EachValue_KnowsItsLineAndPath()
        {
            JsonPlace root = JsonReader.Read("\n{\"one\":\n {\"two\": [1,\n\n 2]},\n\"three\": \"x\"}");

            Assert.That(root.Line, Is.EqualTo(2));
            Assert.That(root["one"].Line, Is.EqualTo(3));
            Assert.That(root["one"]["two"].Items[1].Line, Is.EqualTo(5));
            Assert.That(root["one"]["two"].Items[1].Path, Is.EqualTo("one.two[1]"));
            Assert.That(root["three"].Line, Is.EqualTo(6));
            Assert.That(root["four"], Is.Null);
            Assert.That(root["three"].Wrong("no").Message, Is.EqualTo("line 6, three: no."));
        }

        [TestCase("{\"a\": 1,\n  \"b\" 2}", "line 2: not JSON at column 7.")]
        [TestCase("{\"a\": 1,}", "line 1: not JSON at column 9.")]
        [TestCase("[01]", "line 1: not JSON at column 3.")]
        [TestCase("[1] x", "line 1: not JSON at column 5.")]
        [TestCase("", "line 1: not JSON at column 1.")]
        [TestCase("[\"a", "line 1: not JSON at column 4.")]
        [TestCase("{\"a\": {\n\"b\": 1, \"b\": 2}}", "line 2, a.b: the key stands there twice.")]
        [TestCase("{\"a\": \"\\ud83d\"}", "line 1, a: it is no Unicode.")]
        public void WhatIsWrong_IsSaidWithItsPlace(string text, string told) =>
            Assert.That(Assert.Throws<FormatException>(() => JsonReader.Read(text)).Message, Is.EqualTo(told));

        private static string Damaged(int seed)
        {
            var random = new Random(seed);
            var letters = k_Sample.ToList();
            for (int left = random.Next(4); left > 0; left--)
            {
                int at = random.Next(letters.Count);
                char other = k_Letters[random.Next(k_Letters.Length)];
                switch (random.Next(4))
                {
                    case 0:
                        letters.RemoveAt(at);
                        break;
                    case 1:
                        letters.Insert(at, other);
                        break;
                    case 2:
                        letters.Insert(at, letters[random.Next(letters.Count)]);
                        break;
                    default:
                        letters[at] = other;
                        break;
                }
            }

            return new string(letters.ToArray());
        }

        private static object Read(string text)
        {
            try
            {
                return Tree(JsonReader.Read(text));
            }
            catch (FormatException)
            {
                return null;
            }
        }

        private static object Expected(string text)
        {
            // A lone surrogate is no Unicode; encoding it would put another character in its place.
            if (text.Where((letter, k) => char.IsHighSurrogate(letter) && (k + 1 == text.Length || !char.IsLowSurrogate(text[k + 1]))
                || char.IsLowSurrogate(letter) && (k == 0 || !char.IsHighSurrogate(text[k - 1]))).Any())
            {
                return null;
            }

            try
            {
                using var document = JsonDocument.Parse(text, new JsonDocumentOptions { MaxDepth = 32, AllowDuplicateProperties = false });
                return Tree(document.RootElement);
            }
            catch (Exception problem) when (problem is JsonException or InvalidOperationException)
            {
                return null;
            }
        }

        private static string Tree(JsonPlace value) => value.Kind switch
        {
            JsonKind.Object => $"{{{string.Join(",", value.Members.Select(member => $"<{member.Key}>{Tree(member.Value)}"))}}}",
            JsonKind.List => $"[{string.Join(",", value.Items.Select(Tree))}]",
            JsonKind.Text => $"<{value.Text}>",
            _ => value.Text,
        };

        private static string Tree(JsonElement value) => value.ValueKind switch
        {
            JsonValueKind.Object => $"{{{string.Join(",", Members(value).Select(member => $"<{member.Name}>{Tree(member.Value)}"))}}}",
            JsonValueKind.Array => $"[{string.Join(",", value.EnumerateArray().Select(Tree))}]",
            JsonValueKind.String => $"<{value.GetString()}>",
            _ => value.GetRawText(),
        };

        private static IEnumerable<JsonProperty> Members(JsonElement value) => value.EnumerateObject();
    }
}

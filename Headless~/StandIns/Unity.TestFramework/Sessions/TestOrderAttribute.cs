using System;
using System.Globalization;
using System.Linq;
using NUnit.Framework.Interfaces;
using NUnit.Framework.Internal;
using Unity.StandIns;

namespace StandIns;

/// <summary>
/// Runs the tests of an assembly in the order that an environment variable names: "reversed", or the seed of a shuffle. Namespaces change
/// places within theirs, fixtures within their namespace, tests within their fixture. Without the variable the order is the usual one.
/// </summary>
[StandInExtension]
[AttributeUsage(AttributeTargets.Assembly)]
public sealed class TestOrderAttribute(string variable) : Attribute, IApplyToTest
{
    private const string k_Reversed = "reversed";

    /// <summary>Name of the environment variable.</summary>
    public string Variable { get; } = variable;

    /// <exception cref="FormatException">The variable has neither the word nor a number.</exception>
    public void ApplyToTest(Test test)
    {
        string order = Environment.GetEnvironmentVariable(Variable);
        if (!string.IsNullOrEmpty(order))
            Apply(test, order);
    }

    /// <summary>Orders the children of a test, and theirs.</summary>
    internal static void Apply(Test test, string order)
    {
        Random random = order == k_Reversed ? null : new Random(Seed(order));
        Arrange(test, random);
    }

    private static int Seed(string order) => int.TryParse(order, NumberStyles.None, CultureInfo.InvariantCulture, out int seed)
        ? seed
        : throw new FormatException($"The order of tests is '{k_Reversed}' or a seed from 0 to {int.MaxValue}, not '{order}'.");

    private static void Arrange(ITest test, Random random)
    {
        // The framework sorts them by name later: the shuffle begins with that order, so that a seed means one order.
        ITest[] children = test.Tests.OrderBy(child => child.FullName, StringComparer.Ordinal).ToArray();
        Array.Reverse(children);
        random?.Shuffle(children);
        for (int k = 0; k < children.Length; k++)
        {
            children[k].Properties.Set(PropertyNames.Order, k);
            Arrange(children[k], random);
        }
    }
}

using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using Alate.Drawing;
using NUnit.Framework;

namespace Alate.Tests.Drawing;

/// <summary>Pictures on all cores: each of its item, in their order, and no more at once than memory allows.</summary>
public sealed class ConcurrentlyLaws
{
    private static readonly int[] s_Items = [.. Enumerable.Range(0, 200)];

    [Test]
    public void Results_AreInTheOrderOfTheItems_AndEachIsTold()
    {
        var told = new List<int>();
        int[] squares = Concurrently.Map(s_Items, 1, item =>
        {
            if (item % 7 == 0)
                Thread.Sleep(1);
            return item * item;
        }, told.Add);

        Assert.That(squares, Is.EqualTo(s_Items.Select(item => item * item)));
        Assert.That(told, Is.EqualTo(s_Items.Select(item => item + 1)), "one after the other");
    }

    [Test]
    public void WhatFillsTheMemory_IsMadeAlone()
    {
        int now = 0, most = 0;
        Concurrently.Map(s_Items, 1L << 29, _ =>
        {
            most = Math.Max(most, Interlocked.Increment(ref now));
            Thread.Yield();
            return Interlocked.Decrement(ref now);
        });

        Assert.That(most, Is.EqualTo(1));
    }

    // 512 MiB in all.
    [TestCase(1L, 8, 8)]
    [TestCase(0L, 3, 3)]
    [TestCase(1L << 27, 8, 4)]
    [TestCase((1L << 27) + 1, 8, 3)]
    [TestCase(1L << 40, 8, 1)]
    public void AsManyAreMadeAtOnce_AsCoresAndMemoryAllow(long bytes, int cores, int degree) =>
        Assert.That(Concurrently.Degree(bytes, cores), Is.EqualTo(degree));

    [Test]
    public void AnError_IsTheOneThatWasThrown()
    {
        var problem = new FormatException("no picture");
        int Make(int item) => item == 50 ? throw problem : item;
        Assert.That(() => Concurrently.Map(s_Items, 1, Make), Throws.Exception.SameAs(problem));
    }

    [Test]
    public void OfNothing_NothingIsMade() => Assert.That(Concurrently.Map<int, int>([], 1, item => item), Is.Empty);
}

using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using Unity.Collections;
using Unity.Mathematics;

namespace Alate.Tests.Insects;

/// <summary>The texture of joints over random acts, against a dictionary of what was written.</summary>
public sealed class SkinTableTests
{
    private readonly List<(int Start, int Joints, bool Moves)> m_Blocks = [];
    private readonly Dictionary<int, (float Now, float Last)> m_Written = [];

    [TestCase(1)]
    [TestCase(2)]
    [TestCase(3, Explicit = true, Category = "Long")]
    [TestCase(4, Explicit = true, Category = "Long")]
    public void Blocks_NeverMeet_AndHoldWhatWasWritten_OverRandomActs(int seed)
    {
        m_Blocks.Clear();
        m_Written.Clear();
        var random = new System.Random(seed);
        using var table = new SkinTable(16384);
        for (int act = 0; act < 400; act++)
        {
            for (int k = random.Next(6); k > 0; k--)
                TakeOrReturn(table, random);
            Picture(table, random);
            Check(table);
        }

        Assert.That(table.Texture.height, Is.GreaterThan(16), "it has grown");
    }

    [Test]
    public void AFullTexture_RefusesABlock_AndTakesOneAgainWhenThereIsRoom()
    {
        using var table = new SkinTable(16);
        Assert.That(table.TryTake(4000, false, out int first), Is.True);
        Assert.That(first, Is.Zero);
        Assert.That(table.TryTake(4000, true, out _), Is.False, "its past would not fit");
        Assert.That(table.TryTake(4193, false, out _), Is.False, "16 rows of 512 joints");
        Assert.That(table.TryTake(4192, false, out int second), Is.True);
        Assert.That(second, Is.EqualTo(4000));
        Assert.That(table.TryTake(1, false, out _), Is.False);
        Assert.That(table.Joints, Is.EqualTo(8192));
        table.Return(first, 4000, false);
        Assert.That(table.TryTake(4000, false, out int again), Is.True);
        Assert.That(again, Is.EqualTo(first));
    }

    private void TakeOrReturn(SkinTable table, System.Random random)
    {
        if (m_Blocks.Count > 0 && random.Next(5) < 2)
        {
            int at = random.Next(m_Blocks.Count);
            (int start, int joints, bool moves) = m_Blocks[at];
            table.Return(start, joints, moves);
            m_Blocks.RemoveAt(at);
            m_Written.Remove(start);
            return;
        }

        int wanted = new[] { 36, 48, 200 }[random.Next(3)];
        bool moving = random.Next(40) == 0;
        Assert.That(table.TryTake(wanted, moving, out int taken), Is.True);
        Assert.That(
            m_Blocks.All(block => taken + wanted <= block.Start || block.Start + block.Joints <= taken), Is.True, "blocks meet");
        m_Blocks.Add((taken, wanted, moving));
        NativeArray<float4> texels = table.Texture.GetPixelData<float4>(0);
        foreach (int joint in new[] { taken, taken + wanted - 1 })
        {
            foreach (int texel in new[] { 2 * joint, 2 * joint + table.Last })
            {
                Assert.That(texels[texel], Is.EqualTo(new float4(0f, 0f, 0f, 1f)), "at rest");
                Assert.That(texels[texel + 1], Is.EqualTo(float4.zero));
            }
        }
    }

    private void Picture(SkinTable table, System.Random random)
    {
        table.Begin();
        foreach (int start in m_Written.Keys.ToArray())
            m_Written[start] = (m_Written[start].Now, m_Written[start].Now);
        foreach ((int start, int joints, _) in m_Blocks.Where(_ => random.Next(3) > 0))
        {
            float value = random.NextSingle();
            bool movedOn = m_Written.TryGetValue(start, out (float Now, float Last) before) && random.Next(5) > 0;
            NativeArray<float4> texels = table.Texels;
            for (int joint = 0; joint < joints; joint++)
            {
                texels[2 * (start + joint)] = value + joint;
                texels[2 * (start + joint) + 1] = -value - joint;
            }

            table.MarkWritten();
            if (!movedOn && table.Last > 0)
                table.ForgetPast(start, joints);
            m_Written[start] = (value, movedOn ? before.Now : value);
        }

        table.End();
    }

    private void Check(SkinTable table)
    {
        if (table.Texture == null)
            return;
        NativeArray<float4> texels = table.Texture.GetPixelData<float4>(0);
        Assert.That(table.Joints, Is.EqualTo(m_Blocks.Sum(block => block.Joints)));
        Assert.That(table.Last > 0, Is.EqualTo(m_Blocks.Any(block => block.Moves)));
        foreach ((int start, int joints, _) in m_Blocks.Where(block => m_Written.ContainsKey(block.Start)))
        {
            (float now, float last) = m_Written[start];
            foreach (int joint in new[] { 0, joints - 1 })
            {
                Assert.That(texels[2 * (start + joint)].x, Is.EqualTo(now + joint));
                Assert.That(texels[2 * (start + joint) + 1].w, Is.EqualTo(-now - joint));
                if (table.Last > 0)
                    Assert.That(texels[2 * (start + joint) + table.Last].x, Is.EqualTo(last + joint));
            }
        }
    }
}

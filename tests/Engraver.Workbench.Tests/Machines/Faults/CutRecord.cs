using Engraver.Simulator;

namespace Engraver.Workbench.Tests.Machines.Faults;

/// <summary>Evaluates the tool in the record.</summary>
internal static class CutRecord
{
    /// <summary>A larger change of the commanded position in one sample is a redefinition of the position, not motion. A released motor may move
    /// farther.</summary>
    private const int Jump = 60;

    /// <summary>The record from a row on, in counts of the machine since its first power-on.</summary>
    /// <param name="isFollowed">Whether the controller's counts are followed through its power cycles; otherwise they are taken as they are.</param>
    public static List<MotionSample> Placed(IReadOnlyList<MotionSample> record, int from, bool isFollowed)
    {
        var placed = new List<MotionSample>(Math.Max(0, record.Count - from));
        var (a, b, c) = (0, 0, 0);
        for (var i = 0; i < record.Count; i++)
        {
            var at = record[i];
            if (isFollowed && i > 0 && record[i - 1] is var before && (Commanded(at, 0, before) > Jump || Commanded(at, 1, before) > Jump || Commanded(at, 2, before) > Jump)) (a, b, c) = (a + before.A - at.A, b + before.B - at.B, c + before.C - at.C);
            if (i >= from) placed.Add(at with { A = at.A + a, B = at.B + b, C = at.C + c });
        }

        return placed;
    }

    private static int Commanded(in MotionSample at, int axis, in MotionSample before) => Math.Abs(at[axis] + at.ErrorOf(axis) - before[axis] - before.ErrorOf(axis));

    /// <summary>XY length with the tool in the work, counts.</summary>
    public static double Length(IReadOnlyList<MotionSample> samples, Func<MotionSample, bool> isAtWork)
    {
        var length = 0.0;
        for (var i = 1; i < samples.Count; i++)
        {
            if (isAtWork(samples[i]) && isAtWork(samples[i - 1])) length += double.Hypot(samples[i].A - samples[i - 1].A, samples[i].B - samples[i - 1].B);
        }

        return length;
    }

    /// <summary>Longest standstill with the tool in the work, samples.</summary>
    public static long LongestDwell(IReadOnlyList<MotionSample> samples, Func<MotionSample, bool> isAtWork)
    {
        var longest = 0L;
        for (var i = 1; i < samples.Count; i++)
        {
            if (isAtWork(samples[i - 1])) longest = Math.Max(longest, samples[i].Sample - samples[i - 1].Sample);
        }

        return longest;
    }
}

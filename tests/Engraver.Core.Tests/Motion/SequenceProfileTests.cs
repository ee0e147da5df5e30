using Engraver.Core.Machines;
using Engraver.Core.Motion;

namespace Engraver.Core.Tests.Motion;

public sealed class SequenceProfileTests
{
    private const double A = 1000.0;

    [Fact]
    public void One_speed_is_a_trapezoid()
    {
        var profile = SequenceProfile.Of(Sequence((300, 0), (700, 0)) with { Speed = 200 }, A);
        var expected = new SpeedTrapezoid(1000, 200, A);

        Assert.Equal(expected.Seconds, profile.Seconds, 9);
        for (var part = 0.0; part <= 1.0; part += 0.05)
        {
            Assert.Equal(expected.DistanceAt(part * expected.Seconds), profile.PathAt(part * expected.Seconds), 6);
            Assert.Equal(expected.SpeedAt(part * expected.Seconds), profile.SpeedAfter(part * expected.Seconds), 6);
            Assert.Equal(expected.TimeAt(part * 1000.0), profile.SecondsAt(part * 1000.0), 6);
        }
    }

    /// <summary>200 counts/s after 20 counts; from 500 down to 100 in 15 counts; from 600 up again; to rest over the last 20.</summary>
    [Fact]
    public void A_segment_commands_its_speed_from_its_start()
    {
        var profile = SequenceProfile.Of(Sequence((500, 200), (100, 100), (400, 200)), A);

        Assert.Equal((200.0, 200.0, 100.0, 100.0, 200.0, 200.0), (profile.SpeedAt(20), profile.SpeedAt(500), profile.SpeedAt(515), profile.SpeedAt(600), profile.SpeedAt(615), profile.SpeedAt(980)));
        Assert.Equal((1000.0, 0.0, -1000.0, 0.0, 1000.0, -1000.0), (profile.GainAt(10), profile.GainAt(300), profile.GainAt(510), profile.GainAt(550), profile.GainAt(610), profile.GainAt(990)));
        Assert.Equal(0.2 + (480 / 200.0) + 0.1 + (85 / 100.0) + 0.1 + (365 / 200.0) + 0.2, profile.Seconds, 9);
        Assert.Equal(profile.Seconds, SequenceProfile.SecondsOf(Sequence((500, 200), (100, 100), (400, 200)) with { Acceleration = (int)A }, MachineProfile.Default), 9);
    }

    /// <summary>The brake to rest at the end begins in an earlier segment, whatever the segments command.</summary>
    [Fact]
    public void The_brake_at_the_end_goes_through_several_segments()
    {
        var profile = SequenceProfile.Of(Sequence((100, 200), (5, 200), (5, 180)), A);

        Assert.Equal(200.0, profile.Peak, 6);
        Assert.Equal((Math.Sqrt(2.0 * A * 10.0), Math.Sqrt(2.0 * A * 5.0)), (profile.SpeedAt(100), profile.SpeedAt(105)));
    }

    private static VectorSequence Sequence(params (double Length, int Speed)[] segments)
    {
        var x = 0.0;
        return new VectorSequence(default, 200, [.. segments.Select(segment => new VectorSegment(VectorSegmentKind.Line, new CountsPoint((long)(x += segment.Length), 0), 0, 0.0, 0.0, 0, segment.Length) { Speed = segment.Speed })]);
    }
}

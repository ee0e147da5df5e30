using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Core.Motion;
using Engraver.Galil.Jobs.Journal;
using Engraver.Galil.Language;
using Engraver.TestKit;

namespace Engraver.Galil.Tests.Jobs.Holds;

/// <summary>Holds, stops, cut cables and overrides at random times, one after the other, until the job is complete. By the simulator's record the whole drawing
/// is cut, and parts are cut twice only within the limit.</summary>
public sealed class InterruptionTests : IDisposable
{
    private const double LeadIn = 300.0;

    /// <summary>Counts at the fastest override in the age of the last poll of a job, 60 ms.</summary>
    private const double SinceLastPoll = 40.0 * 60.0;

    private readonly string _folder = Directory.CreateTempSubdirectory("interrupted").FullName;

    /// <summary>632 holds at a corner where the path stops anyway.</summary>
    public static TheoryData<int> Seeds => [.. Enumerable.Range(1, TestExtent.Cases(4, 1000, "ENGRAVER_INTERRUPTIONS")).Append(632).Distinct()];

    /// <summary>Until the machine is at rest; a tool that is moved by an axis is in the work meanwhile, and continues to cut.</summary>
    private const double Braking = 40.0 * 40.0 * 1000.0 / 512.0;

    [Theory]
    [MemberData(nameof(Seeds))]
    public async Task However_it_is_interrupted_the_drawing_is_cut_once(int seed)
    {
        var random = new Random(seed);
        var mode = (JobMode)(seed % 3);
        var program = RandomProgram(random, mode, MachineProfile.Default, seed % 2 == 0 ? null : 8000);
        await using var bench = new SimulatedBench();

        var (resumes, kills) = await CutAsync(bench, random, mode, program, seed);

        HoldRecord.AssertEverythingWasCut(bench, program);
        HoldRecord.AssertNoRepeatedCut(bench, program, (resumes * (LeadIn + SinceLastPoll)) + (RemainingProgram.WholeCountSearch * HoldsAway));
        HoldRecord.AssertNoBurnAtRest(bench, program.Profile, kills);
    }

    /// <summary>The same for a tool that is moved by an axis: lines that rise and fall, plunges, and every point in X, Y and Z.</summary>
    [Theory]
    [MemberData(nameof(Seeds))]
    public async Task However_a_machine_with_a_tool_axis_is_interrupted_the_drawing_is_cut_once(int seed)
    {
        var random = new Random(seed);
        var mode = (JobMode)(seed % 3);
        var program = RandomProgram(random, mode, HeightBench.Profile, feed: null);
        await using var bench = new SimulatedBench();

        var (resumes, _) = await CutAsync(bench, random, mode, program, seed);

        HeightBench.AssertCut(bench, program, (resumes * (LeadIn + SinceLastPoll + Braking)) + (RemainingProgram.WholeCountSearch * HoldsAway));
        HeightBench.AssertGentle(bench, program);
    }

    /// <summary>More than the holds of any seed.</summary>
    private const int HoldsAway = 60;

    /// <returns>How often it was resumed, and how often its host was lost.</returns>
    private async Task<(int Resumes, int Kills)> CutAsync(SimulatedBench bench, Random random, JobMode mode, MotionProgram program, int seed)
    {
        var (from, resumes, kills, journal, outcome) = (default(ResumePosition), 0, 0, "", JobOutcome.Stopped);
        for (var run = 0; outcome != JobOutcome.Complete; run++)
        {
            Assert.InRange(run, 0, 12);
            journal = Path.Combine(_folder, $"{run}.jsonl");
            using var stop = new CancellationTokenSource();
            var trouble = run < 6 ? new RandomInterruption(bench, random, stop) : null;
            var options = SimulatedBench.Job with { Strategy = mode.Strategy(), JournalPath = journal, Frame = default(CountsPoint), Address = "bench", Control = trouble?.Control };
            if (from is not null) options = options with { From = from.Place, LeadIn = LeadIn + from.Doubt };

            var result = await bench.RunAsync(program, options, trouble, stop.Token);

            outcome = result.Outcome;
            Assert.True(outcome is JobOutcome.Complete or JobOutcome.Stopped or JobOutcome.LinkLost, $"seed {seed}, run {run}: {result.Message}");
            bench.Controller.AdvanceUntil(status => status.IsIdle, TimeSpan.FromSeconds(10));
            if (outcome == JobOutcome.Complete) continue;
            resumes++;
            kills += outcome == JobOutcome.LinkLost ? 1 : 0;
            if (result.Place.Segments == program.SegmentCount) break; // only its end was lost
            var found = await FindAsync(bench, program, mode, journal);
            if (found.Refusal is null) from = found; // otherwise it ended before it started, and the next one starts from the same position
        }

        return (resumes, kills);
    }

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    private static async Task<ResumePosition> FindAsync(SimulatedBench bench, MotionProgram program, JobMode mode, string journal)
    {
        await using var session = await bench.OpenAsync();
        return await ResumeFinder.FindAsync(session.Commands, program, mode, journal, CancellationToken.None);
    }

    /// <summary>Strokes of lines and arcs far from each other, so that the cuts can be distinguished. Each segment continues in the direction in which the
    /// previous one ended, and sequences have random lengths. An arc is followed by a line, which ends on whole counts: the generator, which is not used here,
    /// computes the ends of a chain of arcs.</summary>
    /// <remarks>If an axis moves the tool, lines may rise or fall; such a sequence has no arcs.</remarks>
    /// <param name="feed">Counts/s, where an override above it plans the speeds again; the bends allow less than twice of it. Null: 20000, not known to the
    /// job.</param>
    private static MotionProgram RandomProgram(Random random, JobMode mode, MachineProfile profile, int? feed)
    {
        var strokes = new List<MotionStroke>();
        for (var s = random.Next(2, 5); s > 0; s--)
        {
            var at = new CountsPoint(random.Next(-3000, 3000), strokes.Count * 60000, profile.Height is null ? 0 : -random.Next(100, 3000));
            var (isSlope, isSteep) = (false, false);
            var heading = random.Next(0, 360) * 1.0;
            var (start, sequences, begin, segments) = (at, new List<VectorSequence>(), at, new List<VectorSegment>());
            for (var i = random.Next(1, 30); i > 0; i--)
            {
                if (segments.Count == 0) (isSlope, isSteep) = (profile.Height is not null && random.Next(2) == 0, random.Next(3) == 0);
                segments.Add(isSlope || random.Next(3) > 0 || segments is [.., { Kind: VectorSegmentKind.Arc }] ? Line(random, at, heading) : Arc(random, at, heading) is var arc ? arc with { End = arc.End with { Z = at.Z } } : default);
                if (segments[^1].Kind == VectorSegmentKind.Line) segments[^1] = HeightBench.Line(at, segments[^1].End with { Z = isSlope ? Rise(random, at.Z, segments[^1].Length, isSteep) : at.Z });
                heading += segments[^1].DeltaDegrees;
                at = segments[^1].End;
                if (mode != JobMode.Calls && random.Next(8) > 0 && i > 1 && !(isSlope && isSteep)) continue;
                sequences.Add(new VectorSequence(begin, feed ?? 20000, segments) { ChangesHeight = isSlope, Feed = feed });
                (begin, segments) = (at, []);
            }

            strokes.Add(new MotionStroke(strokes.Count, start, sequences));
        }

        return new MotionProgram(profile, default, MotionPrograms.InColumns(strokes)) { Style = mode == JobMode.Calls ? MotionStyle.Calls : MotionStyle.Continuous };
    }

    /// <summary>A gentle slope, which may continue in another one; or a steep line, which is a separate sequence because its bends are sharp.</summary>
    private static int Rise(Random random, int from, double length, bool isSteep) =>
        isSteep ? random.Next(-4000, -100) : Math.Clamp(from + random.Next((int)(-length / 20.0), 1 + (int)(length / 20.0)), -4000, -100);

    private static VectorSegment Line(Random random, CountsPoint from, double heading)
    {
        var length = random.Next(40, random.Next(3) == 0 ? 6000 : 300);
        var to = CountsScale.Round(new Point2D(from.X, from.Y) + Vector2D.FromPolar(length, Angle.FromDegrees(heading)));
        return new VectorSegment(VectorSegmentKind.Line, to, 0, 0, 0, random.Next(100), new Point2D(from.X, from.Y).DistanceTo(new Point2D(to.X, to.Y)));
    }

    private static VectorSegment Arc(Random random, CountsPoint from, double heading)
    {
        var (radius, sign) = (random.Next(500, 2000), random.Next(2) == 0 ? -1.0 : 1.0);
        var delta = sign * random.Next(10, 360);
        var theta = Angle.FromDegrees(heading - (sign * 90.0)).Positive().Degrees;
        var centre = new Point2D(from.X, from.Y) - Vector2D.FromPolar(radius, Angle.FromDegrees(theta));
        var to = CountsScale.Round(centre + Vector2D.FromPolar(radius, Angle.FromDegrees(theta + delta)));
        return new VectorSegment(VectorSegmentKind.Arc, to, radius, theta, delta, random.Next(100), radius * Math.Abs(delta) * Math.PI / 180.0);
    }

    /// <summary>Random holds, steps away during a hold, and overrides, and one end.</summary>
    private sealed class RandomInterruption(SimulatedBench bench, Random random, CancellationTokenSource stop) : IProgress<JobProgress>
    {
        private readonly double _end = 0.1 + (4.0 * random.NextDouble());
        private readonly bool _isKill = random.Next(2) == 0;
        private double _next = random.NextDouble();
        private double _until;
        private int _steps;
        private bool _ended;

        public JobControl Control { get; } = new();

        public void Report(JobProgress value)
        {
            if (_ended) return;
            if (value.Seconds > _end)
            {
                End();
                return;
            }

            if (value.Phase == JobPhase.Held && _steps > 0)
            {
                _steps--;
                _ = Control.MoveAsync(MoveInHold.By(new CountsPoint(random.Next(-4000, 4000), random.Next(-4000, 4000))));
            }

            if (Control.IsHoldWanted && value.Seconds > _until) Control.Resume();
            if (Control.IsHoldWanted || value.Seconds < _next) return;
            (_next, _until) = (value.Seconds + random.NextDouble(), value.Seconds + (0.6 * random.NextDouble()));
            if (random.Next(2) == 0) Hold();
            else (Control.FeedRatio, Control.RapidRatio) = (random.Next(1, 21) / 10.0, random.Next(1, 11) / 10.0);
        }

        private void Hold()
        {
            _steps = random.Next(3);
            Control.Hold();
        }

        private void End()
        {
            _ended = true;
            if (!_isKill)
            {
                stop.Cancel();
                return;
            }

            bench.Controller.DropConnections();
            bench.Controller.Advance(TimeSpan.FromSeconds(3));
        }
    }
}

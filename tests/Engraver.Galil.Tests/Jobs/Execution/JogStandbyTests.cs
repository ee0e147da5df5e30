using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Galil.Jobs;
using Engraver.Galil.Sessions;

namespace Engraver.Galil.Tests.Jobs.Execution;

/// <summary>A controller that is kept ready for jogs, tested by the number of lines between a key press and its BG and by the record of its motors.</summary>
public class JogStandbyTests
{
    private const int Far = 20000;

    private static readonly MotionProgram s_program = new(MachineProfile.Default, default, []);

    [Theory]
    [InlineData(0)]
    [InlineData(19200)]
    [InlineData(9600)]
    public async Task Only_the_first_press_waits_for_the_preparation(int baud)
    {
        await using var bench = new SimulatedBench();
        await bench.SendAsync("FLA=900000", "JGA=4000", "SPB=12000");
        var before = await bench.FingerprintAsync();
        var sent = new List<string>();
        var presses = new List<int>();
        await using (var session = await OpenAsync(bench, baud, sent.Add))
        {
            var pad = new Pad(() => presses.Add(sent.Count), new JogVelocity(600, 0), new JogVelocity(0, -600), new JogVelocity(-600, 600));
            pad.PressNext();
            var result = await JobRunner.StandByAsync(s_program, pad.Standby, session, SimulatedBench.Job, pad, CancellationToken.None);

            Assert.Equal((JobOutcome.Complete, 0), (result.Outcome, result.NotRestored.Count));
        }

        var untilMotion = presses.Select(from => sent.Skip(from).TakeWhile(line => !line.StartsWith("BG", StringComparison.Ordinal)).ToList()).ToList();
        Assert.True(untilMotion[0].Count > 40, string.Join('|', untilMotion[0]));
        Assert.Equal(["hb=5", "JGB=-10000"], untilMotion[1].Select(line => line.TrimEnd('\r')));
        Assert.Equal(3, untilMotion[2].Count); // two axes
        Assert.Equal(before, await bench.FingerprintAsync());
    }

    [Fact]
    public async Task Each_jog_brakes_at_its_release_and_says_where_it_stands()
    {
        await using var bench = new SimulatedBench();
        await using var session = await bench.OpenAsync();
        var pad = new Pad(() => { }, new JogVelocity(600, 0), new JogVelocity(-600, 0), new JogVelocity(0, 600));
        pad.PressNext();

        await JobRunner.StandByAsync(s_program, pad.Standby, session, SimulatedBench.Job, pad, CancellationToken.None);

        var results = await Task.WhenAll(pad.Jogs).WaitAsync(TimeSpan.FromSeconds(60)); // a result is reported on another thread
        Assert.All(results, result => Assert.Equal((JobOutcome.Complete, "The machine is at rest."), (result.Outcome, result.Message)));
        Assert.InRange(results[0].FinalPosition!.Value.X, Far, Far + 2000);
        Assert.InRange(results[1].FinalPosition!.Value.X, -2000, 2000);
        Assert.InRange(results[2].FinalPosition!.Value.Y, Far, Far + 2000);
        Assert.Equal(results[2].FinalPosition, new CountsPoint(bench.Last.A, bench.Last.B));
    }

    [Fact]
    public async Task A_host_that_dies_in_a_later_jog_is_braked_a_quarter_of_a_second_after_its_last_sign()
    {
        await using var bench = new SimulatedBench();
        var lastSign = 0L;
        var session = await bench.OpenAsync(link => link.Sending = line =>
        {
            if (line.StartsWith("hb=", StringComparison.Ordinal)) lastSign = bench.Controller.Status.Sample;
        });
        var pad = new Pad(() => { }, new JogVelocity(600, 0), new JogVelocity(0, 3000));
        pad.FarBehind = 1;
        pad.OnFar = () =>
        {
            bench.Controller.DropConnections();
            bench.ReleaseClock();
        };
        pad.PressNext();

        Assert.Equal(JobOutcome.LinkLost, (await JobRunner.StandByAsync(s_program, pad.Standby, session, SimulatedBench.Job, pad, CancellationToken.None)).Outcome);
        bench.Controller.AdvanceUntil(status => status.IsIdle, TimeSpan.FromSeconds(5));

        var rows = bench.Controller.Record.Snapshot().Where(row => row.Sample > lastSign).ToList();
        var brakes = rows.Zip(rows.Skip(1)).First(pair => pair.Second.B - pair.First.B < 49);
        Assert.InRange(brakes.First.Sample - lastSign, 150, 270);
        Assert.False(bench.Controller.Status.IsMoving);
    }

    [Fact]
    public async Task A_key_that_was_released_before_its_jog_began_moves_nothing()
    {
        await using var bench = new SimulatedBench();
        await using var session = await bench.OpenAsync();
        var standby = new JogStandby();
        var control = new JogControl(new JogVelocity(600, 0));
        var jog = standby.Press(control)!;
        control.Release();
        standby.Leave();

        var result = await JobRunner.StandByAsync(s_program, standby, session, SimulatedBench.Job, null, CancellationToken.None);

        Assert.Equal((JobOutcome.Complete, JobOutcome.Complete), (result.Outcome, (await jog).Outcome));
        Assert.Equal(0, bench.Controller.Record.Count);
        Assert.Null(standby.Press(control));
    }

    [Fact]
    public async Task Without_a_press_the_controller_gets_its_own_program_back_after_a_minute()
    {
        await using var bench = new SimulatedBench();
        await bench.DownloadAsync("#MINE\nEN\n");
        var before = await bench.FingerprintAsync();
        var began = bench.Controller.Status.Sample;
        await using (var session = await bench.OpenAsync())
        {
            var result = await JobRunner.StandByAsync(s_program, new JogStandby(), session, SimulatedBench.Job, null, CancellationToken.None);
            Assert.Equal(JobOutcome.Complete, result.Outcome);
        }

        Assert.InRange(bench.Controller.Status.Sample - began, 60_000, 63_000);
        Assert.Equal(before, await bench.FingerprintAsync());
    }

    [Fact]
    public async Task A_limit_switch_ends_it_with_its_sentence()
    {
        await using var bench = new SimulatedBench();
        await using var session = await bench.OpenAsync();
        var pad = new Pad(() => { }, new JogVelocity(600, 0), new JogVelocity(600, 0), new JogVelocity(600, 0)) { FarBehind = 1 };
        pad.OnFar = () => bench.Controller.SetLimitSwitch(0, forward: true, active: true);
        pad.PressNext();

        var result = await JobRunner.StandByAsync(s_program, pad.Standby, session, SimulatedBench.Job, pad, CancellationToken.None);

        Assert.Equal(JobOutcome.Refused, result.Outcome);
        Assert.Contains("forward limit switch", result.Message, StringComparison.Ordinal);
        Assert.Equal(1, pad.Jogs.Count(jog => jog.IsCompletedSuccessfully));
    }

    private static Task<ControllerSession> OpenAsync(SimulatedBench bench, int baud, Action<string> sending) =>
        baud > 0 ? bench.OpenSerialAsync(baud, sending) : bench.OpenAsync(link => link.Sending = sending);

    /// <summary>An operator who presses one key after the other, each for 20000 counts; between two of them the state of the machine is read.</summary>
    private sealed class Pad : IProgress<JobProgress>
    {
        private readonly Queue<JogVelocity> _ways;
        private readonly Action _pressed;
        private JogControl? _held;
        private (double X, double Y)? _from;

        public Pad(Action pressed, params JogVelocity[] ways)
        {
            (_pressed, _ways) = (pressed, new Queue<JogVelocity>(ways));
            Standby = new JogStandby { Seen = _ => PressNext() };
        }

        public JogStandby Standby { get; }

        public List<Task<JobResult>> Jogs { get; } = [];

        /// <summary>Jogs in which <see cref="OnFar"/> is called instead of a release.</summary>
        public int FarBehind { get; set; } = int.MaxValue;

        public Action OnFar { get; set; } = () => { };

        /// <summary>On the driver's thread: no time passes meanwhile.</summary>
        public void PressNext()
        {
            if (!_ways.TryDequeue(out var way))
            {
                Standby.Leave();
                return;
            }

            (_held, _from) = (new JogControl(way), null);
            _pressed();
            Jogs.Add(Standby.Press(_held)!);
        }

        public void Report(JobProgress value)
        {
            _from ??= (value.X, value.Y);
            if (_held is not { } held || Math.Max(Math.Abs(value.X - _from.Value.X), Math.Abs(value.Y - _from.Value.Y)) < Far) return;
            _held = null;
            if (FarBehind-- > 0) held.Release();
            else OnFar();
        }
    }
}

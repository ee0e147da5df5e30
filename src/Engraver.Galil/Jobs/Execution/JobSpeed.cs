using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Galil.Jobs.Watching;
using Engraver.Galil.Language;
using Engraver.Galil.Programs.Generation;
using Engraver.Galil.Programs.Timing;

namespace Engraver.Galil.Jobs.Execution;

/// <summary>The speed ratios of a job: VR of the path, which the operator's override, the feeder's throttle and a hold determine together, and SP of the
/// rapids. No other class sends them.</summary>
internal sealed class JobSpeed(JobMachine machine, MotionProgram program, JobControl control)
{
    private const double Decimals = 10000.0;

    private double _rapidRatio = 1.0;

    /// <summary>The largest override that the sequences in progress allow; computed only where more than the planned speed is requested.</summary>
    private Lazy<double> _most = new(JobControl.FeedRange.Max);

    /// <summary>The override for which the sequences in progress are planned.</summary>
    private double _planned = 1.0;

    /// <summary>VR as it was last sent.</summary>
    public double Ratio { get; private set; } = 1.0;

    /// <summary>The rapid override.</summary>
    public double RapidRatio => control.RapidRatio;

    /// <summary>The feed override in force, without throttle and hold.</summary>
    public double Override => control.FeedRatio <= _planned ? control.FeedRatio : Math.Min(control.FeedRatio, _most.Value);

    /// <summary>The factor of the planned speeds that is the override, without throttle and hold.</summary>
    public double PathRatio => Override / _planned;

    /// <summary>A ratio that is requested is not in force yet.</summary>
    public bool IsChangeRequested => Requested != Ratio || control.RapidRatio != _rapidRatio;

    /// <summary>The ratio to send, in the four decimals of a number on the wire; 0 while the job is to be held.</summary>
    private double Requested => control.IsHoldWanted ? 0.0 : Math.Round(PathRatio * machine.Phase.Throttle() * Decimals) / Decimals;

    /// <summary>These sequences are run from now on.</summary>
    /// <param name="hostFeeds">The host sends the segments while they are cut: a long run of short ones has a maximum speed.</param>
    public void LimitBy(IReadOnlyList<VectorSequence> sequences, bool hostFeeds) => LimitBy(sequences, hostFeeds, 1.0);

    /// <summary>This sequence is run from now on. Where more than the planned speed is requested and VR may not bring it, its speeds are planned
    /// again.</summary>
    /// <param name="hostFeeds">As for <see cref="LimitBy(IReadOnlyList{VectorSequence}, bool)"/>.</param>
    /// <returns>What is to be sent.</returns>
    public CutSequence Plan(VectorSequence sequence, bool hostFeeds)
    {
        LimitBy([sequence], hostFeeds);
        if (control.FeedRatio <= 1.0 || _most.Value >= control.FeedRatio) return CutSequence.AsPlanned(sequence);
        var cut = CutSequence.Planned(sequence, machine.Profile, control.FeedRatio, program.LeastAcceleration, hostFeeds ? SpeedOfLink : null);
        LimitBy([cut.Sequence], hostFeeds, cut.Ratio);
        return cut;
    }

    private void LimitBy(IReadOnlyList<VectorSequence> sequences, bool hostFeeds, double planned)
    {
        _planned = planned;
        _most = new Lazy<double>(() => planned * Math.Min(
            SpeedHeadroom.Of(sequences, machine.Profile, DmcLimits.FastestSpeed, JobControl.FeedRange.Max),
            hostFeeds ? sequences.Min(sequence => FeedLimit.Headroom([.. sequence.Segments.Select(segment => segment.Length)], sequence.Speed, SecondsPerSegment)) : JobControl.FeedRange.Max));
    }

    /// <summary>Time of a segment on this link, seconds: as planned, or longer where a network was measured to be slower.</summary>
    private double SecondsPerSegment => machine.Line is null && machine.Session.ExchangeSeconds is { } seconds ? Math.Max(FeedLimit.SecondsPerSegment, FeedLimit.ExchangesPerSegment * seconds) : FeedLimit.SecondsPerSegment;

    /// <summary>The highest speed of a sequence at which the link carries its segments.</summary>
    private int SpeedOfLink(VectorSequence planned) => machine.Line is { } line
        ? LinkFeedLimit.FastestSpeed(planned, line, planned.AccelerationOn(machine.Profile))
        : NetworkFeedFitting.SlowestOf(planned, SecondsPerSegment)?.Speed ?? planned.Speed;

    /// <summary>SP of one axis under the rapid override.</summary>
    public int RapidSpeed(MachineAxis axis) => Math.Max(DmcLimits.SlowestSpeed, 2 * (int)(machine.Profile.RapidSpeed(axis) * control.RapidRatio / 2.0));

    /// <summary>A program was started that sets SP to the planned speeds.</summary>
    public void RapidsAreAsPlanned() => _rapidRatio = 1.0;

    /// <summary>Sends the requested VR before a sequence.</summary>
    /// <param name="isKnown">The controller has the ratio that was sent last: an unchanged one is not sent again.</param>
    public ValueTask PutInForceAsync(bool isKnown) => isKnown && Requested == Ratio ? ValueTask.CompletedTask : SendRatioAsync();

    /// <summary>Sends the requested VR, whatever was sent before, and reads it back. VR has no form with a plane letter (galil-dmc.md B.1).</summary>
    public async ValueTask SendRatioAsync()
    {
        var ratio = Requested;
        await machine.Commands.SendAsync(DmcFormat.Text($"VR {ratio}")).ConfigureAwait(false);
        Ratio = ratio;
        await SettingCheck.ReadBackAsync(machine, ("_VRS", ratio, SettingCheck.Exact)).ConfigureAwait(false);
    }

    /// <summary>Puts the requested ratios in force.</summary>
    public async ValueTask AdjustAsync()
    {
        if (Requested != Ratio) await SendRatioAsync().ConfigureAwait(false);

        // SP acts in motion too. A program sets it in its first lines, before its first motion: what is sent before these lines would be overwritten.
        var isSettingUp = machine.Phase.Program is not null && !machine.State.AxesRunning && machine.State.Calls == 0;
        if (control.RapidRatio != _rapidRatio && !isSettingUp) await SendRapidsAsync().ConfigureAwait(false);
    }

    /// <summary>Only of X and Y: SP acts in motion too, and the axis of the tool may be plunging.</summary>
    private ValueTask SendRapidsAsync()
    {
        _rapidRatio = control.RapidRatio;
        machine.Settings.ForgetRapids();
        return machine.Commands.SendAllAsync(new[] { machine.Profile.Axes.X, machine.Profile.Axes.Y }.Select(axis => MotionSettings.SpeedOf(axis.Letter, RapidSpeed(axis))));
    }
}

using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Galil.Language;
using Engraver.Galil.Programs.Generation;

namespace Engraver.Galil.Jobs.Execution;

/// <summary>The one home of VR: what the feeder's throttle, the operator's override and a hold make of it together.</summary>
internal sealed class SpeedRatio(JobControl control)
{
    private const double Decimals = 10000.0;

    /// <summary>The largest override that the sequences under way bear; looked at only where more than the plan is asked for.</summary>
    private Lazy<double> _most = new(JobControl.FeedRange.Fastest);

    /// <summary>The feeder's throttle: at most 1.</summary>
    public double Throttle { get; set; } = 1.0;

    /// <summary>The override in force, without throttle and hold.</summary>
    public double Override => control.FeedRatio <= 1.0 ? control.FeedRatio : Math.Min(control.FeedRatio, _most.Value);

    /// <summary>These sequences are run from now on.</summary>
    /// <param name="hostFeeds">The host sends the segments while they are cut: a long run of short ones has a fastest speed.</param>
    public void Bear(MachineProfile profile, IReadOnlyList<VectorSequence> sequences, bool hostFeeds) => _most = new Lazy<double>(() => Math.Min(
        SpeedHeadroom.Of(sequences, profile, DmcLimits.FastestSpeed, JobControl.FeedRange.Fastest),
        hostFeeds ? sequences.Min(sequence => FeedLimit.For(sequence.Segments, (int)(sequence.Speed * JobControl.FeedRange.Fastest)) / (double)sequence.Speed) : JobControl.FeedRange.Fastest));

    /// <summary>The ratio to send, in the four decimals of a number on the wire; 0 while the job is to be held.</summary>
    public double Wanted => control.IsHoldWanted ? 0.0 : Math.Round(Override * Throttle * Decimals) / Decimals;

    /// <summary>VR has no form with a plane letter (galil-dmc.md B.1).</summary>
    public static string Command(double ratio) => JobMachine.Text($"VR {ratio}");
}

using Engraver.Core.Machines;
using Engraver.Galil.Protocol;

namespace Engraver.Galil.Jobs;

/// <summary>How a job ended.</summary>
/// <remarks>A step that ends the job early throws its end (<see cref="ToException"/>), and <see cref="OfAsync"/> is the only place that catches one
/// (ADR 13). So the steps of a job read as if each of them succeeded.</remarks>
/// <param name="Sentence">What happened, where, and what to do.</param>
/// <param name="Refusal">The command that the controller rejected; null for any other reason.</param>
internal sealed record JobEnd(JobOutcome Outcome, string Sentence, Rejected? Refusal = null)
{
    /// <summary>The cause, for an end with <see cref="JobOutcome.LinkLost"/>; otherwise null.</summary>
    public LinkLoss? Loss { get; private init; }

    /// <summary>Why the machine's position is not reliable from here on; empty while it is.</summary>
    public string Doubt { get; init; } = "";

    /// <summary>The job did not reach the end of what it was to cut.</summary>
    public bool IsEarly => !Outcome.IsAsPlanned();

    public static JobEnd Complete(string sentence) => new(JobOutcome.Complete, sentence);

    /// <summary>The end of a section.</summary>
    public static JobEnd OfSection(JobOutcome outcome, string sentence) => new(outcome, sentence);

    public static JobEnd Refused(Rejected rejected, string where) => new(JobOutcome.Refused, rejected.Explain() + where, rejected);

    public static JobEnd Broken(string sentence) => new(JobOutcome.Refused, sentence);

    public static JobEnd Deviated(string sentence) => new(JobOutcome.Deviated, sentence);

    public static JobEnd LinkLost(string sentence, LinkLoss loss = LinkLoss.Link) => new(JobOutcome.LinkLost, sentence) { Loss = loss };

    /// <summary>The exception by which a step ends the job. No other code than <see cref="OfAsync"/> can catch it by its type.</summary>
    public Exception ToException() => new EarlyEndException(this);

    /// <summary>Runs a step of the job.</summary>
    /// <returns>How the step ended the job; null where the step was completed.</returns>
    public static async ValueTask<JobEnd?> OfAsync(Func<ValueTask> step)
    {
        try
        {
            await step().ConfigureAwait(false);
            return null;
        }
        catch (EarlyEndException early)
        {
            return early.End;
        }
    }

    /// <summary>Throws and catches an end once: the first exception of a process takes milliseconds, which must not delay the stop of a motion.</summary>
    public static ValueTask<JobEnd?> RehearseAsync() => OfAsync(static async () => await OfAsync(static () => throw Broken("").ToException()).ConfigureAwait(false));

    private sealed class EarlyEndException(JobEnd end) : Exception(end.Sentence)
    {
        public JobEnd End => end;
    }
}

using Engraver.Core.Machines;
using Engraver.Galil.Protocol;

namespace Engraver.Galil.Jobs;

/// <summary>The result of one step of a job: the job continues, or it ends for this reason.</summary>
internal sealed record JobStep(JobOutcome Outcome, string Sentence, Rejected? Refusal)
{
    public static JobStep Done { get; } = new(JobOutcome.Complete, "", null);

    /// <summary>The cause, for a step that ended with <see cref="JobOutcome.LinkLost"/>; otherwise null.</summary>
    public LinkLoss? Loss { get; private init; }

    /// <summary>Why the machine's position is not to be trusted from here on; empty while it is.</summary>
    public string Doubt { get; init; } = "";

    public bool Ends => Outcome != JobOutcome.Complete;

    /// <summary>The job stands held and has given up what it was cutting: nothing is under way in the controller, and the axes may be moved by hand. What
    /// is left is cut anew from the place of the ledger.</summary>
    public bool IsParted { get; private init; }

    /// <summary>Ends what is under way, but not the job.</summary>
    public static JobStep Parted { get; } = new(JobOutcome.Stopped, "", null) { IsParted = true };

    public static JobStep Refused(Rejected rejected, string where) => new(JobOutcome.Refused, rejected.Explain() + where, rejected);

    public static JobStep Broken(string sentence) => new(JobOutcome.Refused, sentence, null);

    public static JobStep Deviated(string sentence) => new(JobOutcome.Deviated, sentence, null);

    public static JobStep LinkLost(string sentence, LinkLoss loss = LinkLoss.Link) => new(JobOutcome.LinkLost, sentence, null) { Loss = loss };
}

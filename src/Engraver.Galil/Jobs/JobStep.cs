using Engraver.Galil.Protocol;

namespace Engraver.Galil.Jobs;

/// <summary>The result of one step of a job: it goes on, or it ends and says why.</summary>
internal sealed record JobStep(JobOutcome Outcome, string Sentence, Rejected? Refusal)
{
    public static JobStep Done { get; } = new(JobOutcome.Complete, "", null);

    public bool Ends => Outcome != JobOutcome.Complete;

    public static JobStep Refused(Rejected rejected, string where) => new(JobOutcome.Refused, rejected.Explain() + where, rejected);

    public static JobStep Broken(string sentence) => new(JobOutcome.Refused, sentence, null);

    public static JobStep LinkLost(string sentence) => new(JobOutcome.LinkLost, sentence, null);
}

using Engraver.Core.Machines;

namespace Engraver.Galil.Jobs.Journal;

/// <summary>The operator held or resumed the job, or changed an override.</summary>
/// <param name="Feed">Factor of the programmed feed.</param>
/// <param name="Rapid">Factor of the rapid speed.</param>
/// <param name="X">_RPA.</param>
/// <param name="Time">Controller seconds since the job began.</param>
public sealed record JournalControl(JobPhase Phase, double Feed, double Rapid, long X, long Y, double Time)
{
    public string Kind { get; } = "control";
}

using Engraver.Galil.Programs.Resident;

namespace Engraver.Galil.Jobs.Execution;

/// <summary>Motion by hand that is run as a job without strokes: with its watchdog and its stop, and the controller is left as it was found.</summary>
/// <param name="Resident">The program in the controller meanwhile; null for that of a stream.</param>
/// <param name="Create">What is done with the machine.</param>
internal sealed record HandOperation(ResidentProgram? Resident, Func<JobMachine, IJobStrategy> Create)
{
    /// <summary>The tool is off throughout; false where switching it is all that is done.</summary>
    public bool IsDry { get; init; } = true;
}

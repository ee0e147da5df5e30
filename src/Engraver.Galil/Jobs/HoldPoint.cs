using Engraver.Galil.Jobs.Execution;

namespace Engraver.Galil.Jobs;

/// <summary>Where a hold takes effect.</summary>
internal enum HoldPoint
{
    /// <summary>The motion in progress is completed; the job waits before the next one (<see cref="JobHold.GateAsync"/>).</summary>
    AtGate,

    /// <summary>The path stops where it is (VR 0).</summary>
    OnPath,

    /// <summary>As on the path, and a program that is in a rapid waits at its own gate after it.</summary>
    InProgram,
}

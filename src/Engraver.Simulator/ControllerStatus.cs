namespace Engraver.Simulator;

/// <summary>A snapshot of the controller for code that waits for a condition.</summary>
/// <param name="Sample">Controller time in samples of 1 ms nominal.</param>
/// <param name="IsMoving">An axis moves, or a vector sequence moves along its path.</param>
/// <param name="IsSequenceOpen">A sequence has started and has not ended; it may be at a standstill (VR 0, or out of segments).</param>
/// <param name="IsDry">A started sequence ran out of segments without VE (galil-dmc.md B.7).</param>
/// <param name="RunningThreads">Bit mask as _NO: bit 0 is thread 0.</param>
/// <param name="Outputs">Outputs 1 to 8, bit 0 is output 1.</param>
/// <param name="Underruns">Number of times that a sequence ran dry since power up.</param>
/// <param name="OpenHandles">Handles in use.</param>
/// <param name="SegmentsExecuted">Vector segments executed since power up, over all sequences.</param>
public readonly record struct ControllerStatus(
    long Sample,
    bool IsMoving,
    bool IsSequenceOpen,
    bool IsDry,
    int RunningThreads,
    byte Outputs,
    int Underruns,
    int OpenHandles,
    long SegmentsExecuted)
{
    /// <summary>Nothing moves, no sequence is open and no thread runs: only a command or an input can change the state.</summary>
    public bool IsIdle => !IsMoving && !IsSequenceOpen && RunningThreads == 0;
}

namespace Engraver.Simulator.Motion;

/// <summary>Stop codes of SC (galil-dmc.md A.10).</summary>
internal static class StopCode
{
    public const int Running = 0;
    public const int AtTarget = 1;
    public const int ForwardLimit = 2;
    public const int ReverseLimit = 3;
    public const int Stopped = 4;
    public const int AbortInput = 6;
    public const int Aborted = 7;
    public const int OffOnError = 8;
    public const int EdgeFound = 9;
    public const int Homed = 10;
    public const int SelectiveAbort = 11;
    public const int ContourRunning = 50;
    public const int ContourDone = 51;
    public const int CamRunning = 60;
    public const int CamStopped = 61;
    public const int MotionTimeOut = 99;
    public const int VectorRunning = 100;
    public const int VectorDone = 101;
}

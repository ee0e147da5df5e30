namespace Engraver.Simulator.Motion;

/// <summary>HM, FE and FI (galil-dmc.md C.2). The 21x3 has no HV: the slow stages run at a fixed 256 counts/s [U].</summary>
internal sealed class HomingRun
{
    private const double Creep = 256;
    private readonly AxisMove _kind;
    private bool _homeBefore;
    private double _indexPlace;

    public HomingRun(Axis axis, AxisMove kind)
    {
        _kind = kind;
        _homeBefore = axis.Inputs.Home;
        Phase = kind == AxisMove.FindIndex ? HomingPhase.Index : HomingPhase.Search;
        Speed = kind == AxisMove.FindIndex ? Math.Abs(axis.JogSpeed) : axis.CruiseSpeed;
        Direction = Heading(axis, kind) < 0 ? -1 : 1;
    }

    public HomingPhase Phase { get; private set; }

    /// <summary>Commanded speed; 0 while it brakes.</summary>
    public double Speed { get; private set; }

    public int Direction { get; private set; }

    /// <summary>Direction in which a homing move starts: given by the home input, for FI by the sign of the jog speed.</summary>
    public static double Heading(Axis axis, AxisMove kind) =>
        kind == AxisMove.FindIndex ? axis.JogSpeed : axis.Inputs.Home ? -1 : 1;

    /// <summary>Reads the inputs after one sample of motion.</summary>
    /// <param name="speed">Present speed; set to 0 when the stage ends without a ramp.</param>
    /// <returns>The stop code at the end of the move, null while it continues.</returns>
    public int? Advance(Axis axis, ref double speed)
    {
        switch (Phase)
        {
            case HomingPhase.Search when axis.Inputs.Home != _homeBefore:
                Enter(HomingPhase.SearchBrake, 0, Direction);
                break;
            case HomingPhase.SearchBrake when speed == 0:
                if (_kind == AxisMove.FindEdge) return StopCode.EdgeFound;
                _homeBefore = axis.Inputs.Home;
                Enter(HomingPhase.Approach, Creep, -Direction);
                break;
            case HomingPhase.Approach when axis.Inputs.Home != _homeBefore:
                speed = 0;
                if (axis.IsStepper) return StopCode.Homed;
                Enter(HomingPhase.Index, Creep, 1);
                break;
            case HomingPhase.Index when axis.Inputs.IndexPassed is { } away:
                _indexPlace = axis.Position + away;
                Enter(HomingPhase.IndexBrake, 0, Direction);
                break;
            case HomingPhase.IndexBrake when speed == 0:
                Enter(HomingPhase.Return, Creep, Math.Sign(_indexPlace - axis.Position) < 0 ? -1 : 1);
                break;
            case HomingPhase.Return when (_indexPlace - axis.Position) * Direction <= 0:
                axis.SetPosition(_indexPlace);
                axis.Redefine(0);
                return StopCode.Homed;
        }

        return null;
    }

    private void Enter(HomingPhase phase, double speed, int direction)
    {
        Phase = phase;
        Speed = speed;
        Direction = direction;
    }
}

using Engraver.Simulator.Values;

namespace Engraver.Simulator.Motion;

/// <summary>The settings of one axis that BN burns and RS restores (galil-dmc.md A.6).</summary>
internal sealed class AxisSetup
{
    private readonly (double Speed, double Acceleration, double Deceleration, double Jog) _motion;
    private readonly (int Forward, int Reverse, int OffOnError, double Error) _limits;
    private readonly (FixedPoint Type, bool Off) _motor;
    private readonly (char Master, double Ratio, bool Gantry) _gear;
    private readonly Dictionary<string, FixedPoint> _settings;

    public AxisSetup(Axis axis)
    {
        _motion = (axis.CruiseSpeed, axis.Acceleration, axis.Deceleration, axis.JogSpeed);
        _limits = (axis.ForwardSoftLimit, axis.ReverseSoftLimit, axis.OffOnError, axis.ErrorLimit);
        _motor = (axis.MotorType, axis.MotorOff);
        _gear = (axis.Gear.Master, axis.Gear.Ratio, axis.Gear.IsGantry);
        _settings = new(axis.Settings);
    }

    /// <summary>Also resets the settings that are not burned: the type of the next move, its target, position tracking.</summary>
    public void ApplyTo(Axis axis, MotionKernel motion)
    {
        (axis.CruiseSpeed, axis.Acceleration, axis.Deceleration, axis.JogSpeed) = _motion;
        (axis.ForwardSoftLimit, axis.ReverseSoftLimit, axis.OffOnError, axis.ErrorLimit) = _limits;
        (axis.MotorType, axis.MotorOff) = _motor;
        axis.Gear.Master = _gear.Master;
        axis.Gear.IsGantry = _gear.Gantry;
        axis.Gear.Engage(_gear.Ratio, motion.PlaceOfMaster(_gear.Master));
        axis.Settings.Clear();
        foreach (var (name, value) in _settings) axis.Settings[name] = value;
        (axis.NextMove, axis.RelativeDistance, axis.AbsoluteTarget, axis.IsTracking) = (AxisMove.Relative, 0, 0, false);
    }
}

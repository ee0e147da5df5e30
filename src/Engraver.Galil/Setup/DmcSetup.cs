using System.Diagnostics;
using Engraver.Core.Machines.Setup;
using Engraver.Galil.Language;

namespace Engraver.Galil.Setup;

/// <summary>The numbers of MT, CE, ER, OE and CN, and their meaning (galil-dmc.md C).</summary>
internal static class DmcSetup
{
    /// <summary>The axis whose motor must be off: otherwise MT is refused, and CE would reverse the feedback of a closed servo loop.</summary>
    public static char? NeedsMotorOff(SetupValue value) => value switch
    {
        SetupValue.Motor motor => motor.Axis,
        SetupValue.Encoder encoder => encoder.Axis,
        _ => null,
    };

    public static string Operand(SetupValue value) => value switch
    {
        SetupValue.Motor motor => $"_MT{motor.Axis}",
        SetupValue.Encoder encoder => $"_CE{encoder.Axis}",
        SetupValue.ErrorLimit limit => $"_ER{limit.Axis}",
        SetupValue.OffOnError off => $"_OE{off.Axis}",
        SetupValue.LimitSense => "_CN0",
        SetupValue.HomeSense => "_CN1",
        _ => throw new UnreachableException(),
    };

    /// <summary>The number to send.</summary>
    public static string Command(SetupValue value, double number) => value switch
    {
        SetupValue.LimitSense => "CN " + DmcFormat.Number(number),
        SetupValue.HomeSense => "CN ," + DmcFormat.Number(number),
        _ => $"{Operand(value)[1..]}={DmcFormat.Number(number)}",
    };

    /// <param name="found">The present value: CE also contains the auxiliary encoder (4, 8, 12), and OE the limit switches (2), which are kept.</param>
    public static double Number(SetupValue value, double found) => value switch
    {
        SetupValue.Motor { Type: var type } => Number(type),
        SetupValue.Encoder { Type: var type } => ((int)found / 4 * 4) + (type.IsReversed ? 2 : 0) + (type.Signal == EncoderSignal.PulseAndDirection ? 1 : 0),
        SetupValue.ErrorLimit { Counts: var counts } => counts,
        SetupValue.OffOnError { IsOn: var on } => on ? (int)found | 1 : (int)found & ~1,
        SetupValue.LimitSense { Sense: var sense } => Number(sense),
        SetupValue.HomeSense { Sense: var sense } => Number(sense),
        _ => throw new UnreachableException(),
    };

    /// <returns>Null for a type that is not offered (1.5, a servo with pulse-width output).</returns>
    public static MotorType? Motor(double? number) => number switch
    {
        1.0 or -1.0 => new MotorType(MotorSignal.Servo, number < 0.0),
        2.0 or 2.5 => new MotorType(MotorSignal.LowPulses, number == 2.5),
        -2.0 or -2.5 => new MotorType(MotorSignal.HighPulses, number == -2.5),
        _ => null,
    };

    public static EncoderType? Encoder(double? number) => number is { } sum ? new EncoderType(((int)sum & 1) == 0 ? EncoderSignal.Quadrature : EncoderSignal.PulseAndDirection, ((int)sum & 2) != 0) : null;

    public static SwitchSense? Sense(double? number) => number switch { -1.0 => SwitchSense.Low, 1.0 => SwitchSense.High, _ => null };

    private static double Number(MotorType type) => type.Signal switch
    {
        MotorSignal.Servo => type.IsReversed ? -1.0 : 1.0,
        MotorSignal.LowPulses => type.IsReversed ? 2.5 : 2.0,
        _ => type.IsReversed ? -2.5 : -2.0,
    };

    private static double Number(SwitchSense sense) => sense == SwitchSense.High ? 1.0 : -1.0;
}

using System.Globalization;

namespace Engraver.Core.Machines;

/// <param name="Device">Device path or port name.</param>
/// <param name="Baud">Bits per second, one of <see cref="SerialLine.Rates"/>.</param>
/// <param name="Flow">Flow control.</param>
public sealed record SerialAddress(string Device, int Baud, SerialFlow Flow = SerialFlow.RtsCts) : ControllerAddress
{
    /// <summary>What opens the device; null for the default of the system.</summary>
    public SerialDriver? Driver { get; init; }

    public override string Typed => string.Create(CultureInfo.InvariantCulture, $"serial://{Device}?baud={Baud}{Flow switch { SerialFlow.None => "&flow=none", SerialFlow.XonXoff => "&flow=xonxoff", _ => "" }}{SerialDrivers.OptionText(Driver)}");
}

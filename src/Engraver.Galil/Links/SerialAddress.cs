namespace Engraver.Galil.Links;

/// <param name="Device">Device path or port name.</param>
/// <param name="Baud">Bits per second, one of <see cref="SerialLine.Rates"/>.</param>
/// <param name="Flow">How the two ends hold each other back.</param>
public sealed record SerialAddress(string Device, int Baud, SerialFlow Flow = SerialFlow.RtsCts) : ControllerAddress;

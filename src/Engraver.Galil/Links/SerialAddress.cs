namespace Engraver.Galil.Links;

/// <param name="Device">Device path or port name.</param>
/// <param name="Baud">Bits per second.</param>
public sealed record SerialAddress(string Device, int Baud) : ControllerAddress;

namespace Engraver.Core.Machines.Setup;

public enum EncoderSignal
{
    Quadrature,
    PulseAndDirection,
}

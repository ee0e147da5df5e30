using Engraver.Simulator.Values;

namespace Engraver.Simulator.Motion;

/// <summary>Eight inputs and eight outputs (galil-dmc.md D). Open inputs read 1.</summary>
internal sealed class DigitalIo
{
    public byte Inputs { get; private set; } = 0xFF;

    public byte Outputs { get; private set; }

    public bool Input(int bit) => (Inputs & Mask(bit)) != 0;

    public bool Output(int bit) => (Outputs & Mask(bit)) != 0;

    public void SetInput(int bit, bool level) => Inputs = level ? (byte)(Inputs | Mask(bit)) : (byte)(Inputs & ~Mask(bit));

    public void SetOutput(int bit, bool level) => SetOutputs(level ? (byte)(Outputs | Mask(bit)) : (byte)(Outputs & ~Mask(bit)));

    public void SetOutputs(byte value) => Outputs = value;

    private static int Mask(int bit) => bit is >= 1 and <= 8 ? 1 << (bit - 1) : throw new CommandRefusedException(Tc.OutOfRange);
}

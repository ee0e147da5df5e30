namespace Engraver.Core.Machines;

/// <summary>An output and the level at which the device that it switches is on.</summary>
/// <param name="Output">Number of the output, from 1.</param>
/// <param name="IsActiveLow">The device is on while the output is off.</param>
public readonly record struct OutputSwitch(int Output, bool IsActiveLow = false)
{
    public static implicit operator OutputSwitch(int output) => FromInt32(output);

    /// <summary>Whether the device is on.</summary>
    /// <param name="outputs">Outputs 1 to 8, bit 0 is output 1.</param>
    public bool IsOn(int outputs) => ((outputs & (1 << (Output - 1))) != 0) != IsActiveLow;

    /// <summary>The outputs of a word, bit 0 is output 1; each is on at the high level.</summary>
    public static IEnumerable<OutputSwitch> Of(int outputs) => Enumerable.Range(1, 8).Where(output => (outputs & (1 << (output - 1))) != 0).Select(FromInt32);

    public static OutputSwitch FromInt32(int output) => new(output);
}

namespace Engraver.Core.Machines;

/// <summary>Which axes of the controller move the drawing's X and Y and the tool's height, and their counts per millimetre: the only place for axis letters and
/// for the number of axes that a job moves.</summary>
/// <param name="Z">The axis that moves the tool up and down; null on a machine that only switches its tool.</param>
public sealed record MachineAxes(MachineAxis X, MachineAxis Y, MachineAxis? Z = null)
{
    /// <summary>The operator's names of the axes of <see cref="All"/>, in their order: those of the drawing's axes.</summary>
    public const string Names = "XYZ";

    public static MachineAxes Default { get; } = new(new MachineAxis('A', 1000.0), new MachineAxis('B', 1000.0));

    /// <summary>Every axis that a job moves, in the order of the drawing's axes.</summary>
    public IReadOnlyList<MachineAxis> All => Z is { } z ? [X, Y, z] : [X, Y];

    /// <summary>Every axis that a job moves with the operator's name of it.</summary>
    public IReadOnlyList<(char Name, MachineAxis Axis)> Named => [.. Names.Zip(All)];

    /// <summary>The letters of these axes in that order.</summary>
    public string Letters => string.Concat(All.Select(axis => axis.Letter));

    /// <summary>The operator's name of the axis with a letter of the controller: X, Y or Z, or the letter itself where no job moves that axis.</summary>
    public char NameOf(char letter) => Letters.IndexOf(letter, StringComparison.Ordinal) is >= 0 and var place ? Names[place] : letter;

    /// <summary>The names of several axes, in their order.</summary>
    public string NamesOf(string letters) => string.Concat(letters.Select(NameOf));

    /// <summary>The letters of the two axes of the plane.</summary>
    public string PlaneLetters => string.Concat(X.Letter, Y.Letter);

    public CountsScale Scale => new(X.Scale, Y.Scale, Z?.Scale ?? default);

    /// <summary>Axes A and B with these counts per millimetre.</summary>
    public static MachineAxes FromScale(double x, double y) => new(Default.X with { CountsPerMillimetre = x }, Default.Y with { CountsPerMillimetre = y });
}

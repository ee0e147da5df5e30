namespace Engraver.Core.Posts;

/// <summary>Records the distance by which a controller may leave the path of its program while it cuts, as set by its path control: it rounds corners to keep
/// its speed, and joins short lines.</summary>
public sealed class BlendJudge
{
    /// <summary>Largest distance, millimetres; infinite when the program sets no bound, 0 when the path is run exactly.</summary>
    public double Largest { get; private set; }

    /// <summary>Line of the program's text that first cuts with this distance; 0 for none.</summary>
    public int Line { get; private set; }

    /// <summary>Called for each cut.</summary>
    /// <param name="line">Line of the program's text.</param>
    /// <param name="millimetres">Distance as in <see cref="Largest"/>.</param>
    public void Add(int line, double millimetres)
    {
        if (millimetres > Largest) (Largest, Line) = (millimetres, line);
    }
}

namespace Engraver.Core.Posts;

/// <summary>Keeps how far a controller itself may leave the path of its program while it cuts, where its path control says so: it rounds corners to keep its speed, and joins short lines to one.</summary>
public sealed class BlendJudge
{
    /// <summary>Millimetres; infinite where the program sets no bound, 0 where the path is run exactly.</summary>
    public double Largest { get; private set; }

    /// <summary>Of the program's text, the first that is cut with it; 0 for none.</summary>
    public int Line { get; private set; }

    /// <summary>A cut was made.</summary>
    /// <param name="line">Of the program's text.</param>
    /// <param name="millimetres">As <see cref="Largest"/>.</param>
    public void Add(int line, double millimetres)
    {
        if (millimetres > Largest) (Largest, Line) = (millimetres, line);
    }
}

namespace Engraver.Workbench.Settings;

/// <summary>Centre and height of a view, drawing units.</summary>
public sealed record SavedView(double CentreX, double CentreY, double Height);

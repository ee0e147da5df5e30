namespace Engraver.Samples.Dxf;

/// <summary>The values of $INSUNITS that the samples use.</summary>
internal enum DrawingUnit
{
    Unitless = 0,
    Inches = 1,
    Millimetres = 4,
}

using Avalonia;
using Avalonia.Controls;
using Avalonia.Data.Converters;
using Avalonia.Media;

namespace Engraver.App.Theme;

/// <summary>Converters from the name of a resource, as a view model supplies it, to the resource.</summary>
public static class ResourceConverters
{
    public static FuncValueConverter<string?, Geometry?> Geometry { get; } = new(key => key is not null && Application.Current!.TryFindResource(key, out var found) ? found as Geometry : null);
}

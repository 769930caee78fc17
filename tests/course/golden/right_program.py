"""Chapter 02 as a program."""

from lesson_code.grading import check_task


def restitution_1d(v1, v2, v1_after, v2_after):
    return (v2_after - v1_after) / (v1 - v2)


def collide_1d(m1, v1, m2, v2, restitution):
    approach = v1 - v2
    impulse = (1 + restitution) * approach / (1 / m1 + 1 / m2)
    return v1 - impulse / m1, v2 + impulse / m2


def bounce_heights(height, restitution, count):
    heights = []
    for _ in range(count):
        height = height * restitution**2
        heights.append(height)
    return heights


def rest_time(height, restitution, gravity):
    return (2 * height / gravity) ** 0.5 * (1 + restitution) / (1 - restitution)


check_task("2.1", restitution_1d)

if __name__ == "__main__":
    print(rest_time(1.0, 0.5, 9.81))
